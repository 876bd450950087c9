// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoxAxes.h"

#include "Ticks.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tetmarch
{

/// From points of the world to pixels.
struct BoxAxes::Projection
{
  vtkNew<vtkMatrix4x4> Matrix;
  std::array<double, 6> Bounds;
  std::array<int, 2> Size;

  std::array<double, 3> GetCorner(int corner) const
  {
    return { { this->Bounds[corner & 1 ? 1 : 0], this->Bounds[corner & 2 ? 3 : 2],
      this->Bounds[corner & 4 ? 5 : 4] } };
  }

  /// None of a point behind the camera.
  std::optional<Overlay::Point> Project(const std::array<double, 3>& place) const
  {
    const double world[4] = { place[0], place[1], place[2], 1.0 };
    double view[4];
    this->Matrix->MultiplyPoint(world, view);
    if (!(view[3] > 0.0))
    {
      return std::nullopt;
    }
    return Overlay::Point{ { 0.5 * (view[0] / view[3] + 1.0) * this->Size[0],
      0.5 * (view[1] / view[3] + 1.0) * this->Size[1] } };
  }
};

/// From a corner of the box to the next along an axis.
struct BoxAxes::Edge
{
  int Axis = 0;
  int Corner = 0;
  double Length = 0.0; // in pixels
  Overlay::Point Along{};
  Overlay::Point Outwards{}; // away from the box
};

namespace
{

using Point = Overlay::Point;

Point Move(const Point& from, const Point& direction, double distance)
{
  return { { from[0] + distance * direction[0], from[1] + distance * direction[1] } };
}

double Cross(const Point& a, const Point& b) { return a[0] * b[1] - a[1] * b[0]; }

/// Whether all points lie on one side of a line, or on it: 1 on its left, -1 on its right, 0 on
/// both.
int FindSide(const std::array<Point, 8>& points, const Point& from, const Point& along)
{
  constexpr double tolerance = 0.01; // of a pixel
  double least = 0.0;
  double most = 0.0;
  for (const Point& point : points)
  {
    const double side = Cross(along, { { point[0] - from[0], point[1] - from[1] } });
    least = std::min(least, side);
    most = std::max(most, side);
  }
  return least > -tolerance ? 1 : most < tolerance ? -1 : 0;
}

/// How far text reaches from its middle, in a direction.
double GetReach(const std::string& text, double size, const Point& direction)
{
  const auto [width, height] = Overlay::Measure(text, size);
  return 0.5 * (width * std::abs(direction[0]) + height * std::abs(direction[1]));
}

/// Axes are looked for below the box, then on its left.
double GetPreference(const Point& outwards) { return -outwards[1] - 0.5 * outwards[0]; }

} // namespace

BoxAxes::BoxAxes(Overlay& overlay, double scale)
  : Drawn(overlay)
  , Scale(scale)
{
}

bool BoxAxes::Place(const std::array<double, 6>& bounds, vtkCamera* camera)
{
  this->Drawn.Clear();
  Projection projection;
  projection.Size = this->Drawn.GetPictureSize();
  const double aspect = static_cast<double>(projection.Size[0]) / projection.Size[1];
  projection.Matrix->DeepCopy(camera->GetCompositeProjectionTransformMatrix(aspect, -1, 1));
  projection.Bounds = bounds;
  std::array<Point, 8> corners;
  for (int corner = 0; corner < 8; ++corner)
  {
    const auto point = projection.Project(projection.GetCorner(corner));
    if (!point)
    {
      return false;
    }
    corners[corner] = *point;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    std::optional<Edge> best;
    for (int corner = 0; corner < 8; ++corner)
    {
      const int step = 1 << axis;
      if (corner & step)
      {
        continue;
      }
      const Point& from = corners[corner];
      const Point& to = corners[corner | step];
      Edge edge{ axis, corner, std::hypot(to[0] - from[0], to[1] - from[1]) };
      if (edge.Length < 20.0 * this->Scale)
      {
        continue; // seen from its end
      }
      edge.Along = { { (to[0] - from[0]) / edge.Length, (to[1] - from[1]) / edge.Length } };
      const int side = FindSide(corners, from, edge.Along);
      edge.Outwards = { { side * edge.Along[1], -side * edge.Along[0] } };
      if (side != 0 && (!best || GetPreference(edge.Outwards) > GetPreference(best->Outwards)))
      {
        best = edge;
      }
    }
    if (best)
    {
      this->AddAxis(projection, *best);
    }
  }
  return true;
}

void BoxAxes::AddAxis(const Projection& projection, const Edge& edge)
{
  const double tickLength = 6.0 * this->Scale;
  const double gap = 5.0 * this->Scale;
  const double wishedSize = 15.0 * this->Scale;
  const double titleSize = 18.0 * this->Scale;
  const double least = projection.Bounds[2 * edge.Axis];
  const double most = projection.Bounds[2 * edge.Axis + 1];
  // Labels are up to four times as wide as their letters are high, or the letters are smaller.
  const double labelWidth = 4.0 * wishedSize;
  const double spacing =
    labelWidth * std::abs(edge.Along[0]) + 2.0 * wishedSize * std::abs(edge.Along[1]);
  std::array<double, 3> place = projection.GetCorner(edge.Corner);
  const auto at = [&](double value)
  {
    place[edge.Axis] = value;
    return projection.Project(place).value();
  };

  this->Drawn.AddLine(at(least), at(most));
  double reach = 0.0;
  const std::vector<Tick> ticks = MakeTicks(least, most, static_cast<int>(edge.Length / spacing));
  const double labelSize = Overlay::FindSize(GetLabels(ticks), wishedSize, labelWidth);
  for (const Tick& tick : ticks)
  {
    const Point point = at(tick.Value);
    this->Drawn.AddLine(point, Move(point, edge.Outwards, tickLength));
    const double half = GetReach(tick.Label, labelSize, edge.Outwards);
    this->Drawn.AddText(tick.Label, labelSize, Move(point, edge.Outwards, tickLength + gap + half));
    reach = std::max(reach, 2.0 * half);
  }
  const Point middle = Move(at(least), edge.Along, 0.5 * edge.Length);
  this->Drawn.AddText(std::string(1, "xyz"[edge.Axis]), titleSize,
    Move(middle, edge.Outwards, tickLength + reach + 2.0 * gap + 0.5 * titleSize));
}

} // namespace tetmarch
