// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The lengths that rays see in a hard case, each held against what it must be
 *
 * Each ray is marched in float, as on the GPU: in every second chunk with the fused predicate, in
 * every second one with the portable one.
 *
 * The bound of its length. With positions of at most 1 in the normalised frame and a ray's origin
 * of at most 1, a projected coordinate is a difference (error 2^-24) times a unit vector, summed
 * over three axes (2^-22), and the portable form rounds it to 2^-23: together under 2^-21. For the
 * projected bits signs are exact, and weights to an ulp or two. So what float marches is, up to the
 * rounding of the sum, the exact answer for vertices displaced by that much, and the length must
 * lie between the least and the greatest length that a ray sees while vertices move within that
 * distance. The sum itself adds 2^-24 of the length a cell.
 *
 * Where the cells fill a box, these are the chords of the box made smaller and greater, for every
 * ray. Elsewhere, and where surfaces meet inside of the box, the same ray (the same bits of origin
 * and direction) is marched in double; if that differs by more than the rounding of the sum, the
 * bound is sampled in double: the ray moved aside, in copies of the mesh with displaced vertices.
 * Double in turn is held against brute force, which knows nothing of faces, links and order.
 */
#ifndef tetmarch_testing_LengthCheck_h
#define tetmarch_testing_LengthCheck_h

#include "MarchedCase.h"
#include "RayTotals.h"

#include "Reference/PointKernel.h"

#include "DisplacedMesh.h"
#include "GroundTruth.h"
#include "LengthBounds.h"
#include "MarchedLength.h"
#include "RandomRays.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace tetmarch::testing
{
/// The rays of one chunk in one arithmetic.
template <typename Kernel>
class LengthCheck
{
public:
  LengthCheck(const MarchedCase& check, unsigned seed)
    : Check(check)
    , Float(check.Mesh)
    , Double(check.Mesh)
    , Random(seed)
    , Aside(seed + 1)
    , Stride(lengths::bruteForceStride(check.Mesh))
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
    const double slack = lengths::Eps * (marched.Cells + 16) * 2.0;

    RayTotals& totals = this->Totals;
    ++totals.Rays;
    totals.Met += marched.Cells > 0;
    this->count(totals.Lost, marched.Lost, "lost", number);
    this->count(totals.Guarded, marched.Guarded, "guarded", number);
    this->count(totals.Refused, marched.Refused, "refused", number);
    this->count(totals.NotFinite, std::isfinite(marched.Length) ? 0 : 1, "not finite", number);
    this->count(totals.Negative, marched.Length < 0.0, "negative", number);
    const typename Exact::Ray exactRay = lengths::converted<Exact>(ray);
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
        const lengths::Line line = lengths::lineOf(near);
        return this->Check.BruteForce->pathLength(
                 { near.origin.x, near.origin.y, near.origin.z }, line.Direction) *
               line.DepthPerLength;
      };
      const double answer = bruteForce(ray);
      ++this->Totals.Compared;
      const bool right =
        std::abs(exact - answer) <= lengths::DoubleSlack ||
        this->isSeenNearby(exact, lengths::DoubleSlack, ray, lengths::DoubleSlack, bruteForce) ||
        (this->Random.LastKind != RandomRays::Kind::Generic &&
          this->isRightBesideIt(ray, bruteForce));
      this->count(
        this->Totals.NotTheAnswer, right ? 0 : 1, "not brute force's", number, exact, answer);
    }
  }

  void compareWithBox(int number, const typename Exact::Ray& ray, double length, double slack)
  {
    const lengths::Line line = lengths::lineOf(ray);
    const Vec3 o{ ray.origin.x, ray.origin.y, ray.origin.z };
    const auto chord = [&](double by)
    {
      return lengths::chordOfGrown(this->Check.NormalizedBox, by, o, line.Direction) *
             line.DepthPerLength;
    };
    lengths::Span span;
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
      const auto near = lengths::movedAside(
        ray, VertexDisplacement * std::cos(angle), VertexDisplacement * std::sin(angle));
      const double length = this->Double.march(near).Length;
      if (!(std::abs(length - bruteForce(near)) <= lengths::DoubleSlack))
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

  // Whether the lengths of rays within a distance include this one.
  template <typename LengthOf>
  bool isSeenNearby(
    double length, double slack, const typename Exact::Ray& ray, double within, LengthOf&& lengthOf)
  {
    lengths::Span span;
    span.include(lengthOf(ray));
    for (int i = 0; i < 4000; ++i)
    {
      const double angle = 6.283185307179586 * uniform(this->Aside);
      const double distance = within * std::sqrt(uniform(this->Aside));
      span.include(
        lengthOf(lengths::movedAside(ray, distance * std::cos(angle), distance * std::sin(angle))));
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

  const MarchedCase& Check;
  LengthMarcher<Kernel, float> Float;
  LengthMarcher<Exact, double> Double;
  std::vector<LengthMarcher<Exact, double>> Displaced;
  RandomRays Random;
  std::mt19937 Aside;
  const int Stride;
  RayTotals Totals;
};
} // namespace tetmarch::testing

#endif
