// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Light/TriangleHierarchy.h"

#include "Parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace tetmarch
{
namespace
{

constexpr std::size_t MostTrianglesOfLeaf = 4;

// Margin of boxes, so that no triangle is lost by rounding of boxes and of rays from up to a
// million radii away.
constexpr float BoxMargin = 1e-6f;

} // namespace

// The ray in coordinates whose z axis is the ray's dominant axis, sheared so that the ray is
// parallel to z.
struct TriangleHierarchy::Ray
{
  Vector3 Origin;
  Vector3 Direction;
  Vector3 Inverse;
  double End;
  int X, Y, Z;
  Vector3 Shear;

  Ray(const Vector3& origin, const Vector3& direction, double end)
    : Origin(origin)
    , Direction(direction)
    , Inverse{ { 1 / direction[0], 1 / direction[1], 1 / direction[2] } }
    , End(end)
  {
    const auto isLonger = [&](int a, int b)
    { return std::abs(direction[a]) > std::abs(direction[b]); };
    this->Z = isLonger(1, 0) ? 1 : 0;
    this->Z = isLonger(2, this->Z) ? 2 : this->Z;
    this->X = (this->Z + 1) % 3;
    this->Y = (this->X + 1) % 3;
    const double scale = this->Inverse[this->Z];
    this->Shear = { { direction[this->X] * scale, direction[this->Y] * scale, scale } };
  }

  Vector3 sheared(const Vector3& point) const
  {
    const Vector3 p = point - this->Origin;
    return { { p[this->X] - this->Shear[0] * p[this->Z], p[this->Y] - this->Shear[1] * p[this->Z],
      this->Shear[2] * p[this->Z] } };
  }

  // If a product is NaN, the ray is within the margin of a box, where there is no triangle.
  bool meets(const Box& box) const
  {
    double enter = 0;
    double leave = this->End;
    for (int k = 0; k < 3; ++k)
    {
      const double a = (double(box.Low[k]) - this->Origin[k]) * this->Inverse[k];
      const double b = (double(box.High[k]) - this->Origin[k]) * this->Inverse[k];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
  }
};

TriangleHierarchy::TriangleHierarchy(
  std::vector<Vector3> points, std::vector<std::array<std::uint32_t, 3>> triangles)
  : Points(std::move(points))
  , Triangles(std::move(triangles))
{
  while (MostTrianglesOfLeaf << this->Levels < this->Triangles.size())
  {
    ++this->Levels;
  }
  this->moveToUnitBox();
  this->sort();
  this->fitBoxes();
}

void TriangleHierarchy::moveToUnitBox()
{
  constexpr double most = std::numeric_limits<double>::max();
  Vector3 low{ { most, most, most } };
  Vector3 high{ { -most, -most, -most } };
  for (const auto& triangle : this->Triangles)
  {
    for (std::uint32_t corner : triangle)
    {
      for (int k = 0; k < 3; ++k)
      {
        low[k] = std::min(low[k], this->Points[corner][k]);
        high[k] = std::max(high[k], this->Points[corner][k]);
      }
    }
  }
  double widest = 0;
  for (int k = 0; k < 3 && !this->Triangles.empty(); ++k)
  {
    this->Center[k] = low[k] + 0.5 * (high[k] - low[k]);
    widest = std::max(widest, high[k] - low[k]);
  }
  this->Radius = widest > 0 ? 0.5 * widest : 1;
  for (Vector3& point : this->Points)
  {
    point = scaled(1 / this->Radius, point - this->Center);
  }
}

// The nodes of a level are independent of each other.
void TriangleHierarchy::sort()
{
  std::vector<std::array<float, 3>> centers(this->Triangles.size());
  for (std::size_t t = 0; t < centers.size(); ++t)
  {
    const auto& corners = this->Triangles[t];
    for (int k = 0; k < 3; ++k)
    {
      centers[t][k] = static_cast<float>(
        this->Points[corners[0]][k] + this->Points[corners[1]][k] + this->Points[corners[2]][k]);
    }
  }
  std::vector<std::uint32_t> order(this->Triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  for (std::size_t level = 0; level < this->Levels; ++level)
  {
    parallelFor(0, vtkIdType(1) << level, 1,
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType node = first; node < last; ++node)
        {
          this->sortNode(level, static_cast<std::size_t>(node), centers, order);
        }
      });
  }
  std::vector<std::array<std::uint32_t, 3>> sorted(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    sorted[i] = this->Triangles[order[i]];
  }
  this->Triangles.swap(sorted);
}

// The children are separated by the median along the longest axis.
void TriangleHierarchy::sortNode(std::size_t level, std::size_t node,
  const std::vector<std::array<float, 3>>& centers, std::vector<std::uint32_t>& order) const
{
  const auto at = [&order](std::size_t i)
  { return order.begin() + static_cast<std::ptrdiff_t>(i); };
  const auto first = at(this->begin(level, node));
  const auto middle = at(this->begin(level + 1, 2 * node + 1));
  const auto last = at(this->begin(level, node + 1));
  int axis = 0;
  float longest = -1;
  for (int k = 0; k < 3; ++k)
  {
    const auto bounds = std::minmax_element(
      first, last, [&](std::uint32_t a, std::uint32_t b) { return centers[a][k] < centers[b][k]; });
    const float length = centers[*bounds.second][k] - centers[*bounds.first][k];
    axis = length > longest ? k : axis;
    longest = std::max(longest, length);
  }
  std::nth_element(first, middle, last,
    [&](std::uint32_t a, std::uint32_t b)
    { return std::make_pair(centers[a][axis], a) < std::make_pair(centers[b][axis], b); });
}

TriangleHierarchy::Box TriangleHierarchy::boxOf(std::size_t leaf) const
{
  Box box;
  box.Low.fill(std::numeric_limits<float>::max());
  box.High.fill(std::numeric_limits<float>::lowest());
  for (std::size_t t = this->begin(this->Levels, leaf); t < this->begin(this->Levels, leaf + 1);
       ++t)
  {
    for (std::uint32_t corner : this->Triangles[t])
    {
      for (int k = 0; k < 3; ++k)
      {
        const auto x = static_cast<float>(this->Points[corner][k]);
        box.Low[k] = std::min(box.Low[k], x - BoxMargin);
        box.High[k] = std::max(box.High[k], x + BoxMargin);
      }
    }
  }
  return box;
}

void TriangleHierarchy::fitBoxes()
{
  const std::size_t leaves = std::size_t(1) << this->Levels;
  this->Boxes.resize(2 * leaves);
  parallelFor(0, static_cast<vtkIdType>(leaves),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType leaf = first; leaf < last; ++leaf)
      {
        this->Boxes[leaves + leaf] = this->boxOf(static_cast<std::size_t>(leaf));
      }
    });
  for (std::size_t node = leaves - 1; node > 0; --node)
  {
    const Box& left = this->Boxes[2 * node];
    const Box& right = this->Boxes[2 * node + 1];
    for (int k = 0; k < 3; ++k)
    {
      this->Boxes[node].Low[k] = std::min(left.Low[k], right.Low[k]);
      this->Boxes[node].High[k] = std::max(left.High[k], right.High[k]);
    }
  }
}

// Leaves with fewer triangles than others have their last one twice.
TriangleHierarchy::Packed TriangleHierarchy::packed() const
{
  Packed packed;
  packed.Leaves = std::size_t(1) << this->Levels;
  packed.TrianglesOfLeaf = (this->Triangles.size() + packed.Leaves - 1) / packed.Leaves;
  packed.Texels.resize(2); // no node has the number 0
  for (auto box = this->Boxes.begin() + 1; box != this->Boxes.end(); ++box)
  {
    std::array<float, 4> middle{};
    std::array<float, 4> extent{};
    for (int k = 0; k < 3; ++k)
    {
      middle[k] = 0.5f * (box->Low[k] + box->High[k]);
      extent[k] = std::max(box->High[k] - middle[k], middle[k] - box->Low[k]);
    }
    packed.Texels.push_back(middle);
    packed.Texels.push_back(extent);
  }
  for (std::size_t leaf = 0; leaf < packed.Leaves; ++leaf)
  {
    const std::size_t last = this->begin(this->Levels, leaf + 1) - 1;
    for (std::size_t i = 0; i < packed.TrianglesOfLeaf; ++i)
    {
      for (const std::uint32_t corner :
        this->Triangles[std::min(this->begin(this->Levels, leaf) + i, last)])
      {
        const Vector3& p = this->Points[corner];
        packed.Texels.push_back(
          { { static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]), 0 } });
      }
    }
  }
  return packed;
}

bool TriangleHierarchy::isHit(const Vector3& origin, const Vector3& direction, double end) const
{
  const Ray ray(
    scaled(1 / this->Radius, origin - this->Center), scaled(1 / this->Radius, direction), end);
  const std::size_t leaves = std::size_t(1) << this->Levels;
  std::array<std::size_t, 64> stack{ { 1 } };
  int depth = 1;
  while (depth > 0)
  {
    const std::size_t node = stack[--depth];
    if (!ray.meets(this->Boxes[node]))
    {
      continue;
    }
    if (node < leaves)
    {
      stack[depth++] = 2 * node;
      stack[depth++] = 2 * node + 1;
      continue;
    }
    const std::size_t last = this->begin(this->Levels, node - leaves + 1);
    for (std::size_t t = this->begin(this->Levels, node - leaves); t < last; ++t)
    {
      if (this->isHit(ray, this->Triangles[t]))
      {
        return true;
      }
    }
  }
  return false;
}

// Exchanging two corners exactly changes the sign of an edge function.
bool TriangleHierarchy::isHit(const Ray& ray, const std::array<std::uint32_t, 3>& triangle) const
{
  const Vector3 a = ray.sheared(this->Points[triangle[0]]);
  const Vector3 b = ray.sheared(this->Points[triangle[1]]);
  const Vector3 c = ray.sheared(this->Points[triangle[2]]);
  const double u = c[0] * b[1] - c[1] * b[0];
  const double v = a[0] * c[1] - a[1] * c[0];
  const double w = b[0] * a[1] - b[1] * a[0];
  const bool isInside = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
  const double sum = u + v + w;
  const double t = (u * a[2] + v * b[2] + w * c[2]) / sum;
  return isInside && sum != 0 && t > 0 && t < ray.End;
}

} // namespace tetmarch
