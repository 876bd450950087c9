// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Lengths far from 1: of the mesh, its place, the camera's distance, the volume's matrix.
#include "CaseGroup.h"
#include "CaseOptics.h"
#include "CaseViews.h"

#include "Grids.h"

#include "vtkMath.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace tetmarch::testing
{
namespace
{
const Box UnitBox = { { 0, 0, 0 }, { 1, 1, 1 } };

Box scaled(const Box& box, const Vec3& factors)
{
  Box result;
  for (int a = 0; a < 3; ++a)
  {
    result.Low[a] = factors[a] * box.Low[a];
    result.High[a] = factors[a] * box.High[a];
  }
  return result;
}

Grid stretched(vtkUnstructuredGrid* grid, const Vec3& factors)
{
  return mapped(grid,
    [factors](const Vec3& p, vtkIdType) {
      return Vec3{ factors[0] * p[0], factors[1] * p[1], factors[2] * p[2] };
    });
}

// Each has the pictures of "jittered-cube": its optics and views follow its bounding box.
void addScalesAndOffsets(CaseGroup& group)
{
  for (const auto& [name, scale] : { std::pair<const char*, double>{ "1e-12", 1e-12 },
         { "1e-6", 1e-6 }, { "1e6", 1e6 }, { "1e12", 1e12 } })
  {
    HardCase& hard = fills(group.add(std::string("scaled-") + name,
                             std::string("coordinates and unit distance times ") + name,
                             [scale = scale] {
                               return withOffsetAndScale(jitteredCube(), { 0, 0, 0 }, scale);
                             }),
      scaled(UnitBox, { scale, scale, scale }));
    hard.SamePictureAs = "jittered-cube";
  }
  for (const auto& [name, offset] :
    { std::pair<const char*, double>{ "1e6", 1e6 }, { "1e9", 1e9 } })
  {
    // Multiples of 1/1024 below 2^30 are exact.
    HardCase& hard =
      fills(group.add(std::string("offset-") + name,
              std::string("moved by ") + name + " times its size, in double",
              [offset = offset] {
                return withOffsetAndScale(jitteredCube(), { offset, -offset, offset }, 1.0);
              }),
        { { offset, -offset, offset }, { offset + 1, -offset + 1, offset + 1 } });
    hard.SamePictureAs = "jittered-cube";
  }
  // Multiples of 1/1024 below 2^14 are exact in floats.
  fills(group.add("offset-1e4-float", "moved by 1e4 times its size, points in float",
          [] {
            return withFloatPoints(withOffsetAndScale(jitteredCube(), { 1e4, -1e4, 1e4 }, 1.0));
          }),
    { { 1e4, -1e4, 1e4 }, { 10001, -9999, 10001 } })
    .SamePictureAs = "jittered-cube";
}

// The same size of picture from every distance.
void addCameras(CaseGroup& group)
{
  const Vec3 direction = { -0.55, -0.4, -0.75 };
  const Vec3 up = { 0.1, 1.0, 0.0 };
  fills(group.add("camera-parallel", "parallel, to compare with cameras far away", jitteredCube))
    .Views = { parallelView("view", direction, up, 0.9) };
  // A mesh of diagonal sqrt(3) fills 0.9 of the window: an angle of 2 atan(0.9 sqrt(3) / 2 / d).
  for (const auto& [name, distance] :
    { std::pair<const char*, double>{ "10", 10.0 }, { "1e3", 1e3 }, { "1e6", 1e6 } })
  {
    const double angle = 2.0 * std::atan(0.45 * std::sqrt(3.0) / distance);
    HardCase& hard = fills(group.add(std::string("camera-at-") + name,
      std::string("the camera ") + name + " mesh sizes away, the picture of the same size",
      jitteredCube));
    hard.Views = { perspectiveView("view", direction, up, vtkMath::DegreesFromRadians(angle)) };
    hard.SamePictureAs = distance == 1e6 ? "camera-parallel" : "";
  }
  fills(group.add("view-angles", "view angles of 0.001 and of 150 degrees", jitteredCube)).Views = {
    perspectiveView("0.001-degrees", direction, up, 0.001),
    perspectiveView("150-degrees", direction, up, 150.0)
  };
}

std::array<double, 16> scaling(const Vec3& factors)
{
  return { factors[0], 0, 0, 0, 0, factors[1], 0, 0, 0, 0, factors[2], 0, 0, 0, 0, 1 };
}

// Along every axis and nearly so. A box of very unequal edges covers no pixel where all of it is in
// the window, so each view is as high as the box in the less of the two directions across.
std::vector<HardView> viewsOfThinBox(const Box& box)
{
  const Bounds bounds = [box](vtkUnstructuredGrid*) { return box; };
  Vec3 edges;
  for (int a = 0; a < 3; ++a)
  {
    edges[a] = box.High[a] - box.Low[a];
  }
  const double diagonal = std::hypot(edges[0], edges[1], edges[2]);
  std::vector<HardView> views;
  for (int a = 0; a < 3; ++a)
  {
    const int b = (a + 1) % 3;
    const int c = (a + 2) % 3;
    const double height = std::min(edges[b], edges[c]);
    Vec3 along = { 0, 0, 0 };
    along[a] = -1;
    Vec3 up = { 0, 0, 0 };
    up[c] = 1;
    // Aslant the ray still meets two sides within the window.
    Vec3 nearlyAlong = along;
    nearlyAlong[b] = 0.3 * std::min(1.0, edges[b] / edges[a]);
    nearlyAlong[c] = -0.2 * std::min(1.0, edges[c] / edges[a]);
    const std::string axis(1, "xyz"[a]);
    views.push_back(parallelView("along-" + axis, along, up, 1.1 * height / diagonal, bounds));
    views.push_back(
      parallelView("nearly-along-" + axis, nearlyAlong, up, 1.1 * height / diagonal, bounds));
  }
  return views;
}

// An optical depth of about 3 along the geometric mean of the edges: longer rays see thick cells,
// shorter ones thin cells.
OpticsSetter opticsOfThinBox(const Box& box)
{
  double volume = 1.0;
  for (int a = 0; a < 3; ++a)
  {
    volume *= box.High[a] - box.Low[a];
  }
  return [volume](vtkVolumeProperty* property, vtkUnstructuredGrid* grid)
  {
    setStandardOptics(property, grid);
    property->SetScalarOpacityUnitDistance(std::cbrt(volume) / 11.0);
  };
}

void addAspects(CaseGroup& group)
{
  for (const auto& [name, factors] :
    { std::pair<const char*, Vec3>{ "1e3", { 1e-3, 1, 1e3 } }, { "1e6", { 1e-6, 1, 1e6 } } })
  {
    HardCase& hard = fills(group.add(std::string("matrix-stretching-by-") + name,
      std::string("the volume's matrix divides x and multiplies z by ") + name, jitteredCube));
    hard.Matrix = scaling(factors);
    hard.Views = viewsOfThinBox(scaled(UnitBox, factors));
    hard.SetOptics = opticsOfThinBox(scaled(UnitBox, factors));
  }

  const Box mirrored = { { -1, 0, 0 }, { 0, 1, 1 } };
  fills(group.add("mirrored-points", "x negated: all tetrahedra in the order of negative volume",
          [] {
            return stretched(jitteredCube(), { -1, 1, 1 });
          }),
    mirrored);
  HardCase& mirror =
    fills(group.add("mirrored-by-matrix", "the volume's matrix negates x", jitteredCube));
  mirror.Matrix = scaling({ -1, 1, 1 });
  mirror.Views = standardViewsOf([mirrored](vtkUnstructuredGrid*) { return mirrored; });
  mirror.SamePictureAs = "mirrored-points";

  for (const auto& [name, what, factors] : { std::tuple<const char*, const char*, Vec3>{
                                               "plate", "a mesh of 1 x 1 x 0.001", { 1, 1, 1e-3 } },
         { "rod", "a mesh of 0.001 x 0.001 x 1", { 1e-3, 1e-3, 1 } } })
  {
    const Box box = scaled(UnitBox, factors);
    HardCase& hard = fills(
      group.add(name, what, [factors = factors] { return stretched(jitteredCube(), factors); }),
      box);
    hard.Views = viewsOfThinBox(box);
    hard.SetOptics = opticsOfThinBox(box);
  }
}
} // namespace

void addScaleCases(std::vector<HardCase>& cases)
{
  CaseGroup group(cases, "scale");
  addScalesAndOffsets(group);
  addCameras(group);
  addAspects(group);
}
} // namespace tetmarch::testing
