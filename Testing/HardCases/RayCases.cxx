// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Groups.h"

#include "Grids.h"
#include "Views.h"

#include "vtkCamera.h"
#include "vtkMath.h"

#include <cmath>

namespace tetmarch::testing
{
namespace
{
// An unjittered lattice of spacing 1/4: all its points are multiples of it.
HardCase latticeCase(
  const std::string& name, const std::string& what, const std::vector<HardView>& views)
{
  HardCase hard;
  hard.Name = name;
  hard.Group = "rays";
  hard.What = what;
  hard.Make = [] { return jitteredLattice(4, 0.0, 1, sineField()); };
  hard.Views = views;
  hard.Known = Answer::Box;
  hard.ExactBox = { { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } };
  return hard;
}

// Parallel, with pixel centres on a grid of the given spacing about the middle of the cube: of 65
// pixels the 33rd has the focal point in its centre.
HardView pixelGrid(const std::string& name, const Vec3& direction, const Vec3& up, double spacing)
{
  return { name, [=](vtkCamera* camera, vtkUnstructuredGrid*)
    {
      camera->SetFocalPoint(0.5, 0.5, 0.5);
      camera->SetPosition(
        0.5 + 4.0 * direction[0], 0.5 + 4.0 * direction[1], 0.5 + 4.0 * direction[2]);
      camera->SetViewUp(up[0], up[1], up[2]);
      camera->ParallelProjectionOn();
      camera->SetParallelScale(0.5 * HardPictureSize * spacing);
    } };
}

// Perspective, with the rays of pixel centres through a grid of that spacing on the top of the
// cube.
HardView pixelFan(const std::string& name, const Vec3& eye, double spacing)
{
  return { name, [=](vtkCamera* camera, vtkUnstructuredGrid*)
    {
      camera->SetPosition(eye[0], eye[1], eye[2]);
      camera->SetFocalPoint(eye[0], eye[1], 0.0);
      camera->SetViewUp(0.0, 1.0, 0.0);
      const double slope = 0.5 * HardPictureSize * spacing / (eye[2] - 1.0);
      camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(slope)));
    } };
}
} // namespace

void addRayCases(HardCases& cases)
{
  const double sixtyfourth = 1.0 / 64.0;
  cases.push_back(latticeCase("lattice-along-axes",
    "parallel rays along each axis, through every vertex, edge and face of a plain lattice",
    { pixelGrid("x", { 1, 0, 0 }, { 0, 0, 1 }, sixtyfourth),
      pixelGrid("y", { 0, 1, 0 }, { 0, 0, 1 }, sixtyfourth),
      pixelGrid("z", { 0, 0, 1 }, { 0, 1, 0 }, sixtyfourth),
      pixelGrid("minus-z", { 0, 0, -1 }, { 0, 1, 0 }, sixtyfourth) }));
  cases.push_back(latticeCase("lattice-along-diagonals",
    "parallel rays along diagonals of faces and of the cube, which are edges of cells",
    { pixelGrid("xy", { 1, 1, 0 }, { 0, 0, 1 }, sixtyfourth),
      pixelGrid("yz", { 0, 1, 1 }, { 1, 0, 0 }, sixtyfourth),
      pixelGrid("x-minus-z", { 1, 0, -1 }, { 0, 1, 0 }, sixtyfourth),
      pixelGrid("xyz", { 1, 1, 1 }, { 0, 0, 1 }, std::sqrt(2.0) / 64.0),
      pixelGrid("xy-minus-z", { 1, 1, -1 }, { 0, 0, 1 }, std::sqrt(2.0) / 64.0) }));
  cases.push_back(latticeCase("lattice-fan",
    "rays from a point outside through the vertices of the surface, along planes of faces",
    { pixelFan("over-vertex", { 0.5, 0.5, 3.0 }, sixtyfourth),
      pixelFan("over-corner", { 0.0, 0.0, 2.0 }, sixtyfourth),
      pixelFan("in-plane-of-side", { 1.0, 0.5, 2.5 }, sixtyfourth) }));
  cases.push_back(latticeCase("eye-on-vertex", "the eye exactly on a vertex",
    { eyeAt("inside", { 0.5, 0.5, 0.5 }, { 0.3, 0.2, -1.0 }),
      eyeAt("inside-along-edge", { 0.5, 0.5, 0.5 }, { 1, 0, 0 }),
      eyeAt("on-side", { 0.5, 0.5, 1.0 }, { 0.1, 0.2, -1.0 }),
      eyeAt("on-corner", { 0, 0, 0 }, { 1, 1, 1 }) }));
  cases.push_back(latticeCase("eye-on-edge", "the eye exactly on an edge",
    { eyeAt("inside", { 0.5, 0.5, 0.625 }, { 0.3, 0.2, -1.0 }),
      eyeAt("inside-along-it", { 0.5, 0.5, 0.625 }, { 0, 0, -1 }),
      eyeAt("on-surface", { 0.625, 0.5, 1.0 }, { 0.1, 0.2, -1.0 }),
      eyeAt("on-edge-of-cube", { 0.0, 0.0, 0.625 }, { 1, 1, 0 }) }));
  cases.push_back(latticeCase("eye-in-face", "the eye exactly in the plane of a face",
    { eyeAt("inside", { 0.5, 0.5625, 0.59375 }, { 0.3, 0.2, -1.0 }),
      eyeAt("inside-along-it", { 0.5, 0.5625, 0.59375 }, { 0, 1, 0 }),
      eyeAt("on-surface-inwards", { 0.5625, 0.59375, 1.0 }, { 0.1, 0.2, -1.0 }),
      eyeAt("on-surface-along-it", { 0.5625, 0.59375, 1.0 }, { 1, 0, 0 }) }));
  cases.push_back(latticeCase("rays-in-faces", "the eye outside, in the planes of inner faces",
    { eyeAt("one-plane", { -1.0, 0.5, 0.59375 }, { 1, 0, 0 }),
      eyeAt("two-planes", { -1.0, 0.5, 0.5 }, { 1, 0, 0 }),
      eyeAt("plane-of-side", { -1.0, 0.5, 1.0 }, { 1, 0, 0 }) }));
}
} // namespace tetmarch::testing
