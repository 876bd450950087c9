// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The default view direction: the axes of the picture in the world.
#ifndef TetMarchFirstPicturePicturePlane_h
#define TetMarchFirstPicturePicturePlane_h

#include "Geometry/Vector3.h"

#include <vector>

class vtkDataSet;

namespace tetmarch
{

// Unit vectors, each perpendicular to the others.
struct PicturePlane
{
  Vector3 Right;
  Vector3 Up;
  Vector3 Back; // towards the viewer
};

// up must not be parallel to the direction towards the viewer.
PicturePlane planeFacing(const Vector3& towards, const Vector3& up);

// The corners of a box of points, low and high its first and last ones along each axis, of an image
// or rectilinear grid.
void addCorners(vtkDataSet* lattice, const std::array<int, 3>& low, const std::array<int, 3>& high,
  std::vector<Vector3>& points);

// About a million points, every n-th, of grids with points; the eight corners of images and
// rectilinear grids.
std::vector<Vector3> outlinePoints(const std::vector<vtkDataSet*>& blocks);

// Obliquely along +y and slightly down, z up; flat data are seen from the broad side, slightly
// tilted. Flat: the extent along the shortest principal axis is less than a quarter of that along
// the next.
PicturePlane choosePlane(const std::vector<Vector3>& points);

} // namespace tetmarch

#endif
