// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What clipping planes and cropping leave of a line from point to point
 */
#ifndef tetmarch_testing_CutLine_h
#define tetmarch_testing_CutLine_h

#include "GridBuilder.h"
#include "View/Clipping.h"

#include "vtkPlane.h"
#include "vtkPlaneCollection.h"

#include <algorithm>
#include <vector>

namespace tetmarch::testing
{
/// An end of the line, in the coordinates of both kinds of planes.
struct CutPoint
{
  Vec3 World; ///< coordinates of clipping planes
  Vec3 Data;  ///< coordinates of cropping
};

inline Vec3 mixed(const Vec3& a, const Vec3& b, double fraction)
{
  return { a[0] + (b[0] - a[0]) * fraction, a[1] + (b[1] - a[1]) * fraction,
    a[2] + (b[2] - a[2]) * fraction };
}

/// Regions are numbered as vtkVolumeMapper says: x fastest, from the region below all the first
/// planes on.
inline bool isCroppedAway(const ClippingOptions& options, const Vec3& data)
{
  int region = 0;
  for (int k = 0, factor = 1; k < 3; ++k, factor *= 3)
  {
    const double low = options.CroppingPlanes[2 * k], high = options.CroppingPlanes[2 * k + 1];
    region += factor * (data[k] < low ? 0 : (data[k] < high ? 1 : 2));
  }
  return options.Cropping && (options.CroppingFlags >> region & 1) == 0;
}

inline bool isLeft(const ClippingOptions& options, const CutPoint& point)
{
  bool left = !isCroppedAway(options, point.Data);
  for (int i = 0; options.Planes && i < options.Planes->GetNumberOfItems(); ++i)
  {
    vtkPlane* plane = options.Planes->GetItem(i);
    Vec3 p = point.World;
    left = left && vtkPlane::Evaluate(plane->GetNormal(), plane->GetOrigin(), p.data()) >= 0.0;
  }
  return left;
}

/// Begin and end of each part that is left, as fractions of the line from a to b. The line is cut
/// at every plane, and the middle of each part tells whether it is left.
inline std::vector<std::array<double, 2>> partsLeft(
  const ClippingOptions& options, const CutPoint& a, const CutPoint& b)
{
  std::vector<double> cuts{ 0.0, 1.0 };
  const auto cut = [&cuts](double atA, double atB)
  {
    if ((atA < 0.0) != (atB < 0.0))
    {
      cuts.push_back(atA / (atA - atB));
    }
  };
  for (int i = 0; options.Planes && i < options.Planes->GetNumberOfItems(); ++i)
  {
    vtkPlane* plane = options.Planes->GetItem(i);
    Vec3 p = a.World, q = b.World;
    cut(vtkPlane::Evaluate(plane->GetNormal(), plane->GetOrigin(), p.data()),
      vtkPlane::Evaluate(plane->GetNormal(), plane->GetOrigin(), q.data()));
  }
  for (int i = 0; options.Cropping && i < 6; ++i)
  {
    const double place = options.CroppingPlanes[i];
    cut(a.Data[i / 2] - place, b.Data[i / 2] - place);
  }
  std::sort(cuts.begin(), cuts.end());
  std::vector<std::array<double, 2>> parts;
  for (std::size_t i = 1; i < cuts.size(); ++i)
  {
    const double middle = 0.5 * (cuts[i - 1] + cuts[i]);
    if (isLeft(options, { mixed(a.World, b.World, middle), mixed(a.Data, b.Data, middle) }))
    {
      parts.push_back({ { cuts[i - 1], cuts[i] } });
    }
  }
  return parts;
}

/// How much of the line is left, 0..1.
inline double fractionLeft(const ClippingOptions& options, const CutPoint& a, const CutPoint& b)
{
  double fraction = 0.0;
  for (const auto& part : partsLeft(options, a, b))
  {
    fraction += part[1] - part[0];
  }
  return fraction;
}

/// Of cropping: the named ones, each region alone, and all but each.
inline std::vector<int> croppingFlagsToTest()
{
  std::vector<int> flags{ 0x0002000, 0x2ebfeba, 0x5140145, 0x0417410, 0x7be8bef, 0x7ffffff };
  for (int region = 0; region < 27; ++region)
  {
    flags.push_back(1 << region);
    flags.push_back(0x7ffffff & ~(1 << region));
  }
  return flags;
}
} // namespace tetmarch::testing

#endif
