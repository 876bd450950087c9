// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/PicturePlane.h"

#include "FirstPicture/DrawnArray.h"
#include "Input/SolidCells.h"

#include "vtkDataSet.h"
#include "vtkMath.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetmarch
{

namespace
{

const Vector3 Oblique{ { 0.5, -1.0, 0.45 } };

Vector3 unit(Vector3 v)
{
  vtkMath::Normalize(v.data());
  return v;
}

PicturePlane uprightPlane(const Vector3& towards)
{
  const bool fromAbove = std::abs(unit(towards)[2]) > 0.9;
  return planeFacing(towards, fromAbove ? Vector3{ { 0, 1, 0 } } : Vector3{ { 0, 0, 1 } });
}

struct Axis
{
  Vector3 Direction;
  double Reach = 0;
};

double reachAlong(const std::vector<Vector3>& points, const Vector3& direction)
{
  double least = std::numeric_limits<double>::max();
  double most = std::numeric_limits<double>::lowest();
  for (const Vector3& point : points)
  {
    const double place = dot(point, direction);
    least = std::min(least, place);
    most = std::max(most, place);
  }
  return most - least;
}

// From the shortest to the longest.
std::array<Axis, 3> principalAxes(const std::vector<Vector3>& points)
{
  Vector3 mean{};
  for (const Vector3& point : points)
  {
    add(1.0 / double(points.size()), point, mean);
  }
  double covariance[3][3] = {};
  for (const Vector3& point : points)
  {
    const Vector3 d = point - mean;
    for (int i = 0; i < 3; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        covariance[i][k] += d[i] * d[k];
      }
    }
  }
  double* rows[3] = { covariance[0], covariance[1], covariance[2] };
  double vectors[3][3];
  double* columns[3] = { vectors[0], vectors[1], vectors[2] };
  double values[3];
  vtkMath::Jacobi(rows, values, columns);
  std::array<Axis, 3> axes;
  for (int i = 0; i < 3; ++i)
  {
    axes[i].Direction = { { vectors[0][i], vectors[1][i], vectors[2][i] } };
    axes[i].Reach = reachAlong(points, axes[i].Direction);
  }
  std::sort(
    axes.begin(), axes.end(), [](const Axis& a, const Axis& b) { return a.Reach < b.Reach; });
  return axes;
}

// For an unstructured grid the points of 3D cells, else all.
std::vector<bool> drawnPoints(vtkDataSet* block)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(block);
  std::vector<bool> drawn(static_cast<std::size_t>(block->GetNumberOfPoints()), grid == nullptr);
  if (!grid)
  {
    return drawn;
  }
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    if (isSolidType(grid->GetCellType(i)))
    {
      vtkIdType count = 0;
      const vtkIdType* corners = nullptr;
      grid->GetCellPoints(i, count, corners);
      for (vtkIdType k = 0; k < count; ++k)
      {
        drawn[corners[k]] = true;
      }
    }
  }
  return drawn;
}

void addEveryNth(vtkDataSet* block, std::vector<Vector3>& points)
{
  constexpr vtkIdType most = 1 << 20;
  const std::vector<bool> drawn = drawnPoints(block);
  const vtkIdType step = std::max<vtkIdType>(1, block->GetNumberOfPoints() / most);
  vtkIdType left = 0; // number of points to be skipped
  for (vtkIdType i = 0; i < block->GetNumberOfPoints(); ++i)
  {
    if (!drawn[i] || left-- > 0)
    {
      continue;
    }
    left = step - 1;
    Vector3 point;
    block->GetPoint(i, point.data());
    if (std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]))
    {
      points.push_back(point);
    }
  }
}

} // namespace

PicturePlane planeFacing(const Vector3& towards, const Vector3& up)
{
  PicturePlane plane;
  plane.Back = unit(towards);
  plane.Right = unit(cross(up, plane.Back));
  plane.Up = cross(plane.Back, plane.Right);
  return plane;
}

void addCorners(vtkDataSet* lattice, const std::array<int, 3>& low, const std::array<int, 3>& high,
  std::vector<Vector3>& points)
{
  int n[3];
  isLattice(lattice, n);
  for (int corner = 0; corner < 8; ++corner)
  {
    const vtkIdType i = (corner & 1 ? high : low)[0];
    const vtkIdType j = (corner >> 1 & 1 ? high : low)[1];
    const vtkIdType k = (corner >> 2 & 1 ? high : low)[2];
    Vector3 point;
    lattice->GetPoint((k * n[1] + j) * n[0] + i, point.data());
    points.push_back(point);
  }
}

std::vector<Vector3> outlinePoints(const std::vector<vtkDataSet*>& blocks)
{
  std::vector<Vector3> points;
  for (vtkDataSet* block : blocks)
  {
    int n[3];
    if (!isLattice(block, n))
    {
      addEveryNth(block, points);
    }
    else if (block->GetNumberOfPoints() > 0)
    {
      addCorners(block, {}, { { n[0] - 1, n[1] - 1, n[2] - 1 } }, points);
    }
  }
  return points;
}

PicturePlane choosePlane(const std::vector<Vector3>& points)
{
  if (points.empty())
  {
    return uprightPlane(Oblique);
  }
  constexpr double flat = 0.25;
  constexpr double tilt = 0.2;
  const std::array<Axis, 3> axes = principalAxes(points);
  if (!(axes[0].Reach < flat * axes[1].Reach))
  {
    return uprightPlane(Oblique);
  }
  const double side = dot(axes[0].Direction, Oblique) < 0 ? -1 : 1;
  Vector3 towards = scaled(side, axes[0].Direction);
  add(-tilt * dot(towards, Oblique), towards, towards);
  add(tilt, Oblique, towards);
  return uprightPlane(towards);
}

} // namespace tetmarch
