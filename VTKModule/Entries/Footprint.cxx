// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Entries/Footprint.h"

#include "Mesh/BoundaryHierarchy.h"
#include "View/FittedDepths.h"
#include "View/View.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetmarch
{
namespace
{

// Maximum displacement of a ray, in pixels, by rounding of its clip coordinates to float.
constexpr double PixelMargin = 1.0 / 64;
constexpr double MostDepth = 65535;

using Row = std::array<double, 4>;

Row rowOf(const View& view, int row)
{
  const auto& m = view.NormalizedToClip;
  return { { m[4 * row], m[4 * row + 1], m[4 * row + 2], m[4 * row + 3] } };
}

double product(const Row& row, const Vertex& v)
{
  return row[0] * double(v.X) + row[1] * double(v.Y) + row[2] * double(v.Z) + row[3];
}

double lengthOf(const Row& row) { return std::hypot(row[0], row[1], row[2]); }

// Converts a row of clip coordinates, given that of w, to pixels.
Row toPixels(const Row& row, const Row& w, int pixels)
{
  Row result{};
  for (int k = 0; k < 4; ++k)
  {
    result[k] = 0.5 * pixels * (row[k] + w[k]);
  }
  return result;
}

// The depth 0..65535 of points of the volume: the distance from the eye along the line of sight or,
// in parallel projection, from the near plane.
Row depthRow(const VolumeFrame& frame, const View& view)
{
  const Row w = rowOf(view, 3);
  Row row = lengthOf(w) > 0 ? w : rowOf(view, 2);
  const double reach = std::numeric_limits<double>::min() + reachOf(row.data(), frame);
  for (int k = 0; k < 3; ++k)
  {
    row[k] *= 0.5 * MostDepth / reach;
  }
  row[3] = 0.5 * MostDepth; // of the volume's centre
  return row;
}

// Without branches, which could not be predicted.
double leastOf(double a, double b, double c) { return std::min(std::min(a, b), c); }
double greatestOf(double a, double b, double c) { return std::max(std::max(a, b), c); }

int pixelFrom(double x, int least, int most)
{
  return static_cast<int>(std::min(std::max(x, double(least)), double(most)));
}

} // namespace

// The ray of pixel i is at i + 1/2. Each edge is clipped to the strip between the lines of the
// first and the last row.
void ProjectedFace::narrow(int bottom, int top, int& left, int& right) const
{
  const double low = bottom + 0.5 - this->Margin;
  const double high = top + 0.5 + this->Margin;
  double least = std::numeric_limits<double>::max();
  double most = std::numeric_limits<double>::lowest();
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int from = this->Y[i] <= this->Y[j] ? i : j;
    const int to = from == i ? j : i;
    if (this->Y[to] >= low && this->Y[from] <= high)
    {
      const double rise = this->Y[to] - this->Y[from];
      const double slope = rise > 0 ? (this->X[to] - this->X[from]) / rise : 0.0;
      const double first =
        this->Y[from] >= low ? this->X[from] : this->X[from] + (low - this->Y[from]) * slope;
      const double last =
        this->Y[to] <= high ? this->X[to] : this->X[from] + (high - this->Y[from]) * slope;
      least = leastOf(least, first, last);
      most = greatestOf(most, first, last);
    }
  }
  const int first = left;
  const int last = right;
  left = std::max(first, pixelFrom(std::ceil(least - this->Margin - 0.5), first, last + 1));
  right = std::min(last, pixelFrom(std::floor(most + this->Margin - 0.5), first - 1, last));
}

FaceProjection::FaceProjection(const VolumeFrame& frame, const View& view, int width, int height)
  : ToX(toPixels(rowOf(view, 0), rowOf(view, 3), width))
  , ToY(toPixels(rowOf(view, 1), rowOf(view, 3), height))
  , ToW(rowOf(view, 3))
  , Depth(depthRow(frame, view))
  , LengthX(lengthOf(this->ToX))
  , LengthY(lengthOf(this->ToY))
  , LengthW(lengthOf(this->ToW))
  , LeastW(double(HierarchyMargin) * this->LengthW)
  , Mirrored(view.Mirrored)
  , LastX(width - 1)
  , LastY(height - 1)
{
}

std::array<float, 4> FaceProjection::depthPlane() const
{
  std::array<float, 4> plane;
  std::transform(this->Depth.begin(), this->Depth.end(), plane.begin(),
    [](double d) { return static_cast<float>(d); });
  return plane;
}

std::uint16_t FaceProjection::nearestOf(const FaceCorners& corners) const
{
  const auto depth = [&](int i) { return product(this->Depth, *corners[i]); };
  // One less, since the shader rounds depths.
  const double nearest = std::floor(leastOf(depth(0), depth(1), depth(2))) - 1;
  return static_cast<std::uint16_t>(std::min(std::max(nearest, 0.0), MostDepth));
}

// Of a face that isn't wholly before the eye: whether all of it is behind, or beyond one side of
// the picture, where no point of it has become one of the picture by rounding.
bool FaceProjection::isOutOfSight(const FaceCorners& corners) const
{
  const auto isBeyond = [&](const Row& plane)
  {
    const double rounding = double(HierarchyMargin) * lengthOf(plane);
    return greatestOf(product(plane, *corners[0]), product(plane, *corners[1]),
             product(plane, *corners[2])) < -rounding;
  };
  const auto upTo = [&](int last, const Row& row)
  {
    Row plane = this->ToW;
    std::transform(plane.begin(), plane.end(), row.begin(), plane.begin(),
      [last](double w, double pixels) { return (last + 1) * w - pixels; });
    return plane;
  };
  return isBeyond(this->ToW) || isBeyond(this->ToX) || isBeyond(this->ToY) ||
         isBeyond(upTo(this->LastX, this->ToX)) || isBeyond(upTo(this->LastY, this->ToY));
}

ProjectedFace FaceProjection::project(const FaceCorners& corners) const
{
  ProjectedFace face;
  double nearest = std::numeric_limits<double>::max();
  double reach = 0; // of the pixels from the lower left
  for (int i = 0; i < 3; ++i)
  {
    const double w = product(this->ToW, *corners[i]);
    face.X[i] = product(this->ToX, *corners[i]) / w;
    face.Y[i] = product(this->ToY, *corners[i]) / w;
    nearest = std::min(nearest, w);
    reach = greatestOf(reach, std::abs(face.X[i]), std::abs(face.Y[i]));
  }
  if (nearest < this->LeastW)
  {
    face = {};
    face.Margin = std::numeric_limits<double>::infinity();
    return face;
  }
  const double slope = std::max(this->LengthX, this->LengthY) + reach * this->LengthW;
  face.Margin = PixelMargin + double(HierarchyMargin) * slope / nearest;
  return face;
}

Footprint FaceProjection::footprintOf(const FaceCorners& corners) const
{
  const ProjectedFace face = this->project(corners);
  if (std::isinf(face.Margin))
  {
    return this->isOutOfSight(corners) ? Footprint() : this->wholePicture(corners);
  }
  const double left = leastOf(face.X[0], face.X[1], face.X[2]);
  const double right = greatestOf(face.X[0], face.X[1], face.X[2]);
  const double bottom = leastOf(face.Y[0], face.Y[1], face.Y[2]);
  const double top = greatestOf(face.Y[0], face.Y[1], face.Y[2]);
  const double area = (face.X[1] - face.X[0]) * (face.Y[2] - face.Y[0]) -
                      (face.X[2] - face.X[0]) * (face.Y[1] - face.Y[0]);
  Footprint footprint;
  if ((this->Mirrored ? -area : area) < -2 * face.Margin * (right - left + top - bottom))
  {
    return footprint;
  }
  const double margin = face.Margin + 0.5;
  const double first[2] = { std::ceil(left - margin), std::ceil(bottom - margin) };
  const double last[2] = { std::floor(right + margin - 1), std::floor(top + margin - 1) };
  if (first[0] > last[0] || first[1] > last[1] || first[0] > this->LastX ||
      first[1] > this->LastY || last[0] < 0 || last[1] < 0)
  {
    return footprint;
  }
  const auto pixel = [](double x, int most)
  { return static_cast<std::uint16_t>(pixelFrom(x, 0, most)); };
  footprint.Left = pixel(first[0], this->LastX);
  footprint.Right = pixel(last[0], this->LastX);
  footprint.Bottom = pixel(first[1], this->LastY);
  footprint.Top = pixel(last[1], this->LastY);
  footprint.Nearest = this->nearestOf(corners);
  return footprint;
}

Footprint FaceProjection::wholePicture(const FaceCorners& corners) const
{
  Footprint footprint;
  footprint.Left = 0;
  footprint.Bottom = 0;
  footprint.Right = static_cast<std::uint16_t>(this->LastX);
  footprint.Top = static_cast<std::uint16_t>(this->LastY);
  footprint.Nearest = this->nearestOf(corners);
  return footprint;
}

} // namespace tetmarch
