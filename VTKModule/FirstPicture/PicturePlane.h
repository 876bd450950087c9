// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// From where the data is looked at: the axes of the picture in the world.
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

// Of grids with points every n-th of about a million, of images and rectilinear grids the eight
// corners.
std::vector<Vector3> outlinePoints(const std::vector<vtkDataSet*>& blocks);

// Obliquely along +y and a little down, z up; what is flat is seen from its broad side, a little
// tilted. Flat: along the least of its principal axes the data reaches less than a quarter as far
// as along the next.
PicturePlane choosePlane(const std::vector<Vector3>& points);

} // namespace tetmarch

#endif
