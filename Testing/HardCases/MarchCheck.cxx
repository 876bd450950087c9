// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MarchCheck.h"

#include "Mesh/TetMeshBuilder.h"
#include "Optics/FittingTable.h"
#include "Reference/Kernel.h"

#include "ClosedForms.h"
#include "DisplacedMesh.h"
#include "MarchedLength.h"
#include "MarchedMesh.h"
#include "Oracle.h"
#include "RandomRays.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace tetmarch::testing
{
namespace
{
constexpr double Eps = 5.9604644775390625e-08; // 2^-24
// Of double against brute force; a boundary seen at 1e-8 of a right angle magnifies 1e-16 to it.
constexpr double DoubleSlack = 1e-8;

// Every so many rays are compared with brute force, which costs as much as all the others.
int bruteForceStride(const TetMesh& mesh)
{
  return std::clamp(static_cast<int>(mesh.Tets.size() / 64), 8, 4096);
}

// The chord of a box made greater on all sides, or smaller, so that nothing may be left of it.
double chordOfGrown(const Box& box, double by, const Vec3& origin, const Vec3& direction)
{
  Box grown = box;
  for (int k = 0; k < 3; ++k)
  {
    grown.Low[k] -= by;
    grown.High[k] += by;
    if (grown.Low[k] > grown.High[k])
    {
      return 0.0;
    }
  }
  return boxChord(origin, direction, grown.Low, grown.High);
}

// The least and the greatest of some lengths.
struct Span
{
  double Least = std::numeric_limits<double>::infinity();
  double Most = -std::numeric_limits<double>::infinity();

  void include(double length)
  {
    this->Least = std::min(this->Least, length);
    this->Most = std::max(this->Most, length);
  }
  bool holds(double length, double slack) const
  {
    return length >= this->Least - slack && length <= this->Most + slack;
  }
};

template <typename To, typename From>
typename To::Ray converted(const From& ray)
{
  const auto vec = [](const auto& v) {
    return glsl::Vec3<double>{ double(v.x), double(v.y), double(v.z) };
  };
  typename To::Ray result;
  result.origin = vec(ray.origin);
  result.right = vec(ray.right);
  result.up = vec(ray.up);
  result.direction = vec(ray.direction);
  return result;
}

// The march takes the points that lie neither to the right nor up of the ray, and how far they are
// along its direction. Each of the three is a vector of floats, which are as orthonormal as floats
// are.
struct Line
{
  Vec3 Direction; // of unit length
  double DepthPerLength;
};
template <typename Ray>
Line lineOf(const Ray& ray)
{
  const auto across = glsl::cross(ray.right, ray.up);
  const double along = glsl::dot(across, ray.direction);
  const double length = std::copysign(std::sqrt(glsl::dot(across, across)), along);
  return { { across.x / length, across.y / length, across.z / length }, along / length };
}

template <typename Ray>
Ray movedAside(Ray ray, double right, double up)
{
  ray.origin = ray.origin + ray.right * right + ray.up * up;
  return ray;
}
} // namespace

std::int64_t RayTotals::failures() const
{
  return this->Lost + this->Guarded + this->Refused + this->NotFinite + this->Negative +
         this->OutOfBound + this->NotTheAnswer;
}

RayTotals& RayTotals::operator+=(const RayTotals& other)
{
  this->Rays += other.Rays;
  this->Met += other.Met;
  this->Compared += other.Compared;
  this->Lost += other.Lost;
  this->Guarded += other.Guarded;
  this->Refused += other.Refused;
  this->NotFinite += other.NotFinite;
  this->Negative += other.Negative;
  this->OutOfBound += other.OutOfBound;
  this->NotTheAnswer += other.NotTheAnswer;
  this->WorstError = std::max(this->WorstError, other.WorstError);
  this->WorstGeneric = std::max(this->WorstGeneric, other.WorstGeneric);
  if (this->FirstFailure.empty())
  {
    this->FirstFailure = other.FirstFailure;
  }
  return *this;
}

MarchCheck::MarchCheck(const HardCase& hard)
  : Case(hard)
{
  const Grid grid = hard.Make();
  std::string error;
  if (buildTetMesh(grid, {}, this->Mesh, error) != BuildStatus::Done)
  {
    throw std::runtime_error(hard.Name + ": " + error);
  }
  ensureHierarchy(this->Mesh);
  if (this->Mesh.Tets.empty())
  {
    return;
  }
  if (hard.CellScalars)
  {
    this->Range = makeCellScalars(grid->GetCellData()->GetScalars(), this->Mesh, this->CellScalars);
  }
  else
  {
    this->Range = setPointScalars(grid, grid->GetPointData()->GetScalars(), this->Mesh);
  }
  vtkNew<vtkVolumeProperty> property;
  (hard.SetOptics ? hard.SetOptics : setStandardOptics)(property, grid);
  this->Table = fittingTable(property, tetmarch::OpacityLaw::Unstructured, this->Range.Low,
    this->Range.High, DefaultAccuracy);
  this->UnitDistance = property->GetScalarOpacityUnitDistance() / this->Mesh.Radius;
  if (hard.Known == Answer::Box)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->NormalizedBox.Low[k] =
        (hard.ExactBox.Low[k] - this->Mesh.Center[k]) / this->Mesh.Radius;
      this->NormalizedBox.High[k] =
        (hard.ExactBox.High[k] - this->Mesh.Center[k]) / this->Mesh.Radius;
    }
  }
  // A box without inner surfaces needs none of them.
  if (hard.Known != Answer::Box || this->Mesh.NeedsHierarchy)
  {
    const std::size_t tets = this->Mesh.Tets.size();
    const int together = tets < 50000 ? DisplacementsTogether : 0;
    const int copies = together + static_cast<int>(std::clamp<std::size_t>(20000 / tets, 16, 200));
    for (int i = 0; i < copies; ++i)
    {
      this->Displaced.push_back(
        i < together ? displacedTogether(this->Mesh, VertexDisplacement, i)
                     : displacedMesh(this->Mesh, VertexDisplacement, static_cast<unsigned>(i)));
    }
  }
  if (hard.Known == Answer::Union)
  {
    this->BruteForce = std::make_unique<OracleScene>(asGrid(this->Mesh), constantModel());
  }
}

MarchCheck::~MarchCheck() = default;

// The rays of one chunk in one arithmetic.
template <typename Kernel>
class MarchCheck::Lengths
{
public:
  Lengths(const MarchCheck& check, unsigned seed)
    : Check(check)
    , Float(check.Mesh)
    , Double(check.Mesh)
    , Random(seed)
    , Aside(seed + 1)
    , Stride(bruteForceStride(check.Mesh))
  {
    for (const TetMesh& mesh : check.Displaced)
    {
      this->Displaced.emplace_back(mesh);
    }
  }

  RayTotals run(int rays)
  {
    for (int i = 0; i < rays; ++i)
    {
      this->castOne(i);
    }
    return this->Totals;
  }

private:
  using Exact = PointKernel<double>;

  void castOne(int number)
  {
    const auto ray = this->Random.template next<Kernel, float>(this->Float.March, this->Check.Mesh);
    const Marched marched = this->Float.march(ray);
    const double slack = Eps * (marched.Cells + 16) * 2.0;

    RayTotals& totals = this->Totals;
    ++totals.Rays;
    totals.Met += marched.Cells > 0;
    this->count(totals.Lost, marched.Lost, "lost", number);
    this->count(totals.Guarded, marched.Guarded, "guarded", number);
    this->count(totals.Refused, marched.Refused, "refused", number);
    this->count(totals.NotFinite, std::isfinite(marched.Length) ? 0 : 1, "not finite", number);
    this->count(totals.Negative, marched.Length < 0.0, "negative", number);
    const typename Exact::Ray exactRay = converted<Exact>(ray);
    if (this->Check.Case.Known == Answer::Box)
    {
      this->compareWithBox(number, exactRay, marched.Length, slack);
    }
    else
    {
      this->compareWithDouble(number, exactRay, marched.Length, slack);
    }
  }

  void compareWithDouble(int number, const typename Exact::Ray& ray, double length, double slack)
  {
    const double exact = this->Double.march(ray).Length;
    const double error = std::abs(length - exact);
    this->remember(error);
    const bool within = error <= slack || this->isSeenInDisplaced(length, slack, ray) ||
                        this->isSeenInDisplaced(length, slack + this->surfaceRounding(ray), ray);
    this->count(this->Totals.OutOfBound, within ? 0 : 1, "out of bound", number, length, exact);

    if (this->Check.BruteForce && number % this->Stride == this->Stride / 2)
    {
      const auto bruteForce = [&](const typename Exact::Ray& near)
      {
        const Line line = lineOf(near);
        return this->Check.BruteForce->pathLength(
                 { near.origin.x, near.origin.y, near.origin.z }, line.Direction) *
               line.DepthPerLength;
      };
      const double answer = bruteForce(ray);
      ++this->Totals.Compared;
      const bool right = std::abs(exact - answer) <= DoubleSlack ||
                         this->isSeenNearby(exact, DoubleSlack, ray, DoubleSlack, bruteForce) ||
                         (this->Random.LastKind != RandomRays::Kind::Generic &&
                           this->isRightBesideIt(ray, bruteForce));
      this->count(
        this->Totals.NotTheAnswer, right ? 0 : 1, "not brute force's", number, exact, answer);
    }
  }

  void compareWithBox(int number, const typename Exact::Ray& ray, double length, double slack)
  {
    const Line line = lineOf(ray);
    const Vec3 o{ ray.origin.x, ray.origin.y, ray.origin.z };
    const auto chord = [&](double by) {
      return chordOfGrown(this->Check.NormalizedBox, by, o, line.Direction) * line.DepthPerLength;
    };
    Span span;
    span.include(chord(VertexDisplacement));
    span.include(chord(-VertexDisplacement));
    ++this->Totals.Compared;
    this->remember(std::abs(length - chord(0.0)));
    // Where two surfaces meet inside, each may be off.
    const bool right = span.holds(length, slack) ||
                       (!this->Displaced.empty() && this->isSeenInDisplaced(length, slack, ray));
    this->count(
      this->Totals.NotTheAnswer, right ? 0 : 1, "not the box's", number, length, chord(0.0));
  }

  void remember(double error)
  {
    RayTotals& totals = this->Totals;
    totals.WorstError = std::max(totals.WorstError, error);
    if (this->Random.LastKind == RandomRays::Kind::Generic)
    {
      totals.WorstGeneric = std::max(totals.WorstGeneric, error);
    }
  }

  // A ray made to run exactly in the seam of two surfaces without common points may pass between
  // them. Those beside it may not.
  template <typename LengthOf>
  bool isRightBesideIt(const typename Exact::Ray& ray, LengthOf&& bruteForce)
  {
    for (int i = 0; i < 8; ++i)
    {
      const double angle = 6.283185307179586 * uniform(this->Aside);
      const auto near =
        movedAside(ray, VertexDisplacement * std::cos(angle), VertexDisplacement * std::sin(angle));
      const double length = this->Double.march(near).Length;
      if (!(std::abs(length - bruteForce(near)) <= DoubleSlack))
      {
        return false;
      }
    }
    return true;
  }

  // How far the rounding of positions moves all the surfaces that the ray crosses, to first order:
  // each by its displacement over the sine of the angle at which it is met. Samples of displaced
  // meshes tell on which side of an edge the ray may run, but not that where there are many
  // surfaces, whose worst cases don't come together.
  double surfaceRounding(const typename Exact::Ray& ray) const
  {
    const TetMesh& mesh = this->Check.Mesh;
    double sum = 0.0;
    for (const auto& face : mesh.BoundaryFaces)
    {
      glsl::Vec3<double> p[3];
      for (int i = 0; i < 3; ++i)
      {
        const Vertex& v = mesh.Vertices[face[i]];
        const glsl::Vec3<double> to =
          glsl::Vec3<double>{ double(v.X), double(v.Y), double(v.Z) } - ray.origin;
        p[i] = { glsl::dot(to, ray.right), glsl::dot(to, ray.up), glsl::dot(to, ray.direction) };
      }
      int left = 0, right = 0;
      for (int i = 0; i < 3; ++i)
      {
        const auto& a = p[i];
        const auto& b = p[(i + 1) % 3];
        const double turn = a.x * b.y - a.y * b.x;
        left += turn >= 0.0 ? 1 : 0;
        right += turn <= 0.0 ? 1 : 0;
      }
      if (left == 3 || right == 3)
      {
        const auto normal = glsl::cross(p[1] - p[0], p[2] - p[0]);
        const double length = std::sqrt(glsl::dot(normal, normal));
        sum += VertexDisplacement * length / std::max(std::abs(normal.z), 1e-300);
      }
    }
    return sum;
  }

  bool isSeenInDisplaced(double length, double slack, const typename Exact::Ray& ray)
  {
    std::size_t copy = 0;
    return this->isSeenNearby(length, slack, ray, VertexDisplacement,
      [&](const typename Exact::Ray& near)
      { return this->Displaced[copy++ % this->Displaced.size()].march(near).Length; });
  }

  // Whether rays within a distance see shorter and longer ways.
  template <typename LengthOf>
  bool isSeenNearby(
    double length, double slack, const typename Exact::Ray& ray, double within, LengthOf&& lengthOf)
  {
    Span span;
    span.include(lengthOf(ray));
    for (int i = 0; i < 4000; ++i)
    {
      const double angle = 6.283185307179586 * uniform(this->Aside);
      const double distance = within * std::sqrt(uniform(this->Aside));
      span.include(
        lengthOf(movedAside(ray, distance * std::cos(angle), distance * std::sin(angle))));
      if (span.holds(length, slack))
      {
        return true;
      }
    }
    return false;
  }

  void count(std::int64_t& counter, int by, const char* what, int number, double got = 0.0,
    double wanted = 0.0)
  {
    counter += by;
    if (by != 0 && this->Totals.FirstFailure.empty())
    {
      std::ostringstream text;
      text.precision(9);
      text << what << ": ray " << number << " of kind " << static_cast<int>(this->Random.LastKind)
           << ", length " << got << " instead of " << wanted;
      this->Totals.FirstFailure = text.str();
    }
  }

  const MarchCheck& Check;
  LengthMarcher<Kernel, float> Float;
  LengthMarcher<Exact, double> Double;
  std::vector<LengthMarcher<Exact, double>> Displaced;
  RandomRays Random;
  std::mt19937 Aside;
  const int Stride;
  RayTotals Totals;
};

// Finite colours and transmittances, whatever the scalars and functions.
template <typename Kernel>
class MarchCheck::Colours
{
public:
  Colours(const MarchCheck& check, unsigned seed)
    : Check(check)
    , March(kernelOf<Kernel, float>(check.Mesh, check.Table, DefaultAccuracy))
    , Random(seed)
  {
    this->March.CellScalars = check.CellScalars.data();
    this->March.tableScale = static_cast<float>(check.Table.scale(check.Range.width()));
    this->March.tableOffset = static_cast<float>(check.Table.offset(check.Range.Low));
  }

  RayTotals run(int rays)
  {
    const auto perUnit = static_cast<float>(std::min(1.0 / this->Check.UnitDistance, 1e15));
    RayTotals totals;
    for (int i = 0; i < rays; ++i)
    {
      const auto ray = this->Random.template next<Kernel, float>(this->March, this->Check.Mesh);
      const auto marched = this->March.castRay(ray, -1, perUnit, -3e38f, 3e38f);
      const auto& c = marched.radiance.color;
      const float t = marched.radiance.transmittance;
      const auto inRange = [](float x) { return x >= -1e-6f && x <= 1.0f + 1e-5f; };
      const bool sound = inRange(c.x) && inRange(c.y) && inRange(c.z) && inRange(t);
      ++totals.Rays;
      totals.Met += marched.cells > 0;
      totals.Lost += marched.lost;
      totals.Guarded += marched.guarded;
      totals.Refused += marched.refused;
      totals.NotFinite += sound ? 0 : 1;
      if (!sound && totals.FirstFailure.empty())
      {
        std::ostringstream text;
        text << "ray " << i << ": colour " << c.x << ' ' << c.y << ' ' << c.z << ", transmittance "
             << t;
        totals.FirstFailure = text.str();
      }
    }
    return totals;
  }

private:
  const MarchCheck& Check;
  Kernel March;
  RandomRays Random;
};

RayTotals MarchCheck::run(unsigned chunk, int rays) const
{
  if (this->Mesh.Tets.empty())
  {
    return {};
  }
  const unsigned seed = 2654435761u * (chunk + 1);
  const bool fused = chunk % 2 == 0;
  if (!this->CellScalars.empty())
  {
    return Colours<CellKernel<float>>(*this, seed).run(rays);
  }
  if (this->Case.Group == "optics")
  {
    return fused ? Colours<PointKernel<float>>(*this, seed).run(rays)
                 : Colours<PortablePointKernel<float>>(*this, seed).run(rays);
  }
  return fused ? Lengths<PointKernel<float>>(*this, seed).run(rays)
               : Lengths<PortablePointKernel<float>>(*this, seed).run(rays);
}
} // namespace tetmarch::testing
