// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Groups.h"

#include "Grids.h"
#include "Views.h"

#include "vtkPoints.h"

#include <cmath>

namespace tetmarch::testing
{
namespace
{
// Points are multiples of 2^-10, so that powers of two as scales, and offsets up to 2^40, keep them
// exactly.
Grid base()
{
  const Grid grid = jitteredLattice(5, 0.15, 3, sineField());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double p[3];
    grid->GetPoint(i, p);
    for (double& x : p)
    {
      x = std::ldexp(std::round(std::ldexp(x, 10)), -10);
    }
    grid->GetPoints()->SetPoint(i, p);
  }
  return grid;
}

HardCase cubeCase(
  const std::string& name, const std::string& what, const Vec3& offset, double scale)
{
  HardCase hard;
  hard.Name = name;
  hard.Group = "scale";
  hard.What = what;
  hard.Make = [=] { return withOffsetAndScale(base(), offset, scale); };
  hard.Known = Answer::Box;
  hard.ExactBox = { offset, { offset[0] + scale, offset[1] + scale, offset[2] + scale } };
  hard.SamePictureAs = name == "cube" ? "" : "cube";
  return hard;
}

HardCase stretched(const std::string& name, const std::string& what, const Vec3& stretch)
{
  HardCase hard;
  hard.Name = name;
  hard.Group = "scale";
  hard.What = what;
  hard.Make = [=]
  {
    const Grid grid = withOffsetAndScale(base(), { 0.0, 0.0, 0.0 }, 1.0);
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      double p[3];
      grid->GetPoint(i, p);
      grid->GetPoints()->SetPoint(i, p[0] * stretch[0], p[1] * stretch[1], p[2] * stretch[2]);
    }
    return grid;
  };
  hard.Known = Answer::Box;
  hard.ExactBox = { { 0.0, 0.0, 0.0 }, stretch };
  return hard;
}

HardCase transformed(
  const std::string& name, const std::string& what, const std::array<double, 16>& matrix)
{
  HardCase hard = cubeCase(name, what, { 0.0, 0.0, 0.0 }, 1.0);
  hard.Matrix = matrix;
  hard.SamePictureAs.clear();
  return hard;
}

HardCase seen(const std::string& name, const std::string& what, const HardView& view)
{
  HardCase hard = cubeCase(name, what, { 0.0, 0.0, 0.0 }, 1.0);
  hard.Views = { view };
  hard.SamePictureAs.clear();
  return hard;
}
} // namespace

void addScaleCases(HardCases& cases)
{
  cases.push_back(cubeCase("cube", "a jittered cube, to compare with", { 0.0, 0.0, 0.0 }, 1.0));
  cases.push_back(cubeCase("scale-1e-12", "coordinates times 1e-12", { 0.0, 0.0, 0.0 }, 1e-12));
  cases.push_back(cubeCase("scale-1e-6", "coordinates times 1e-6", { 0.0, 0.0, 0.0 }, 1e-6));
  cases.push_back(cubeCase("scale-1e6", "coordinates times 1e6", { 0.0, 0.0, 0.0 }, 1e6));
  cases.push_back(cubeCase("scale-1e12", "coordinates times 1e12", { 0.0, 0.0, 0.0 }, 1e12));
  cases.push_back(
    cubeCase("offset-1e6", "a million mesh sizes from the origin", { 1e6, -2e6, 3e6 }, 1.0));
  cases.push_back(
    cubeCase("offset-1e9", "a billion mesh sizes from the origin", { 1e9, 1e9, -1e9 }, 1.0));
  {
    HardCase hard = cubeCase("float-points-offset-1e4",
      "points in single precision ten thousand mesh sizes from the origin, which moves them by "
      "1e-3",
      { 16384.0, 0.0, 0.0 }, 1.0);
    hard.Make = [] {
      return withFloatPoints(withOffsetAndScale(base(), { 16384.0, 0.0, 0.0 }, 1.0));
    };
    hard.SamePictureAs.clear();
    cases.push_back(hard);
  }
  const Vec3 oblique{ 0.9, -1.6, 1.1 };
  cases.push_back(
    seen("camera-10", "the eye 10 radii away", perspectiveFrom("10-radii", oblique, 10.0)));
  cases.push_back(
    seen("camera-1e3", "the eye 1000 radii away", perspectiveFrom("1e3-radii", oblique, 1e3)));
  cases.push_back(
    seen("camera-1e6", "the eye a million radii away", perspectiveFrom("1e6-radii", oblique, 1e6)));
  cases.back().SamePictureAs = "camera-1e3";
  cases.push_back(seen("angle-0.001", "a view angle of 0.001 degrees, zoomed far into the mesh",
    perspectiveOfAngle("0.001-degrees", oblique, 10.0, 0.001)));
  cases.push_back(seen("angle-150", "a view angle of 150 degrees, close by",
    perspectiveOfAngle("150-degrees", oblique, 1.1, 150.0)));
  cases.push_back(transformed("volume-scaled-1e3", "a volume scaled by 1e-3, 1 and 1e3",
    { { 1e-3, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1e3, 0, 0, 0, 0, 1 } }));
  cases.push_back(transformed("volume-scaled-1e6", "a volume scaled by 1e-6, 1 and 1e6",
    { { 1e-6, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1e6, 0, 0, 0, 0, 1 } }));
  cases.push_back(transformed("volume-mirrored", "a volume mirrored in x",
    { { -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 } }));
  cases.push_back(transformed("volume-sheared", "a volume sheared, turned and moved far away",
    { { 0.8, -3.0, 0.1, 1e5, 0.6, 0.9, -0.4, 2e5, 0.2, 0.5, 1.7, -3e5, 0, 0, 0, 1 } }));
  cases.push_back(stretched("rod-1-1000", "a rod of 1 x 1 x 1000", { 1.0, 1.0, 1000.0 }));
  cases.push_back(stretched("plate-1000-1", "a plate of 1000 x 1000 x 1", { 1000.0, 1000.0, 1.0 }));
}
} // namespace tetmarch::testing
