// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "View/Clipping.h"

#include "Geometry/VolumeFrame.h"

#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

using Triple = std::array<double, 3>;

double nearby(double place) { return std::clamp(place, -Clipping::Farthest, Clipping::Farthest); }

// Add the plane in the normalised frame, whose axes in the world are the columns of the volume's
// matrix. Positions are subtracted first, since they are large where the data lies far from the
// origin.
bool addPlane(vtkPlane* plane, vtkMatrix4x4* toWorld, const VolumeFrame& frame, Clipping& clipping)
{
  const double* normal = plane->GetNormal();
  const double* origin = plane->GetOrigin();
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  std::array<double, 4> made{};
  for (int r = 0; r < 3; ++r)
  {
    const double n = normal[r] / length;
    double toCenter = toWorld->GetElement(r, 3) - origin[r];
    for (int k = 0; k < 3; ++k)
    {
      made[k] += n * toWorld->GetElement(r, k) * frame.Radius;
      toCenter += toWorld->GetElement(r, k) * frame.Center[k];
    }
    made[3] += n * toCenter;
  }
  const double unit = std::hypot(made[0], made[1], made[2]);
  const bool usable =
    length > 0 && std::isfinite(length) && unit > 0 && std::isfinite(unit + made[3]);
  for (double& x : made)
  {
    x /= unit;
  }
  made[3] = nearby(made[3]);
  clipping.Planes.push_back(made);
  return usable;
}

std::string addPlanes(
  vtkPlaneCollection* planes, vtkVolume* volume, const VolumeFrame& frame, Clipping& clipping)
{
  const int count = planes->GetNumberOfItems();
  if (count > Clipping::MostUserPlanes)
  {
    return "There are " + std::to_string(count) + " clipping planes, but at most " +
           std::to_string(Clipping::MostUserPlanes) + " can be used. Remove some.";
  }
  for (int i = 0; i < count; ++i)
  {
    if (!addPlane(planes->GetItem(i), volume->GetMatrix(), frame, clipping))
    {
      return "Clipping plane " + std::to_string(i) +
             " is none: its normal must not be 0, and normal and origin must be finite "
             "(vtkPlane::SetNormal, SetOrigin).";
    }
  }
  return {};
}

// A box of regions: their indices along each axis, 0..2.
struct RegionBox
{
  std::array<int, 3> First{ { 2, 2, 2 } };
  std::array<int, 3> Last{ { 0, 0, 0 } };
};

// Whether the remaining regions form a box; sets the box.
bool areBox(int flags, RegionBox& box)
{
  int count = 0;
  for (int region = 0; region < 27; ++region)
  {
    if (flags >> region & 1)
    {
      const int at[3] = { region % 3, region / 3 % 3, region / 9 };
      for (int k = 0; k < 3; ++k)
      {
        box.First[k] = std::min(box.First[k], at[k]);
        box.Last[k] = std::max(box.Last[k], at[k]);
      }
      ++count;
    }
  }
  int volume = 1;
  for (int k = 0; k < 3; ++k)
  {
    volume *= box.Last[k] - box.First[k] + 1;
  }
  return count == volume;
}

// Add half-spaces whose intersection is the box.
void addBox(const RegionBox& box, const Triple& low, const Triple& high, Clipping& clipping)
{
  for (int k = 0; k < 3; ++k)
  {
    std::array<double, 4> plane{};
    if (box.First[k] > 0)
    {
      plane[k] = 1;
      plane[3] = -(box.First[k] == 1 ? low : high)[k];
      clipping.Planes.push_back(plane);
    }
    if (box.Last[k] < 2)
    {
      plane[k] = -1;
      plane[3] = (box.Last[k] == 1 ? high : low)[k];
      clipping.Planes.push_back(plane);
    }
  }
}

std::string addCropping(
  const ClippingOptions& options, const VolumeFrame& frame, Clipping& clipping)
{
  Triple low, high;
  for (int k = 0; k < 3; ++k)
  {
    const double least = options.CroppingPlanes[2 * k];
    const double most = options.CroppingPlanes[2 * k + 1];
    if (std::isnan(least) || std::isnan(most))
    {
      return "A cropping region plane is not a number (SetCroppingRegionPlanes).";
    }
    // As in VTK: a widget may be dragged this far.
    clipping.LeavesNothing = clipping.LeavesNothing || least >= most;
    low[k] = nearby((least - frame.Center[k]) / frame.Radius);
    high[k] = nearby((most - frame.Center[k]) / frame.Radius);
  }
  const int flags = options.CroppingFlags & Clipping::AllRegions;
  clipping.LeavesNothing = clipping.LeavesNothing || flags == 0;
  RegionBox box;
  if (areBox(flags, box))
  {
    addBox(box, low, high, clipping);
    return {};
  }
  clipping.Cropped = true;
  clipping.CroppingLow = low;
  clipping.CroppingHigh = high;
  clipping.CroppingFlags = flags;
  return {};
}

} // namespace

std::string makeClipping(
  const ClippingOptions& options, vtkVolume* volume, const VolumeFrame& frame, Clipping& clipping)
{
  clipping = {};
  std::string error;
  if (options.Planes)
  {
    error = addPlanes(options.Planes, volume, frame, clipping);
  }
  if (error.empty() && options.Cropping)
  {
    error = addCropping(options, frame, clipping);
  }
  return error;
}

} // namespace tetmarch
