// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The visible part of images and rectilinear grids.
#ifndef TetMarchFirstPictureShownPart_h
#define TetMarchFirstPictureShownPart_h

#include "FirstPicture/DrawnArray.h"
#include "Geometry/Vector3.h"

#include <functional>
#include <vector>

namespace tetmarch
{

// Points whose convex hull contains the visible cells: the corners of one box for each row of
// cells. A value is visible if its extinction is above a hundredth of the maximum. About a hundred
// values along each axis are examined; each represents the cells up to the next examined value.
// Hidden cells and values that aren't finite are not visible. Empty if nothing is visible.
std::vector<Vector3> findShownCorners(const std::vector<vtkDataSet*>& lattices,
  const DrawnArray& drawn, const std::function<double(double value)>& extinction);

} // namespace tetmarch

#endif
