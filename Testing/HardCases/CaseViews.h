// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Camera positions for hard cases
 */
#ifndef tetmarch_testing_CaseViews_h
#define tetmarch_testing_CaseViews_h

#include "HardCase.h"

namespace tetmarch::testing
{
/// The box that a view is to show.
using Bounds = std::function<Box(vtkUnstructuredGrid*)>;
Box boundsOf(vtkUnstructuredGrid* grid);

/// From the centre of the box look along the direction, in parallel; half of the picture's height
/// is that part of half the box's diagonal.
HardView parallelView(const std::string& name, const Vec3& direction, const Vec3& up,
  double partOfDiagonal = 1.0, const Bounds& bounds = boundsOf);

/// In perspective, with half of the picture's height at the centre of the box 0.9 of half its
/// diagonal. The eye lies on the side that the direction comes from.
HardView perspectiveView(const std::string& name, const Vec3& direction, const Vec3& up,
  double angle, const Bounds& bounds = boundsOf);

/// standardViews() of another box than the grid's.
std::vector<HardView> standardViewsOf(const Bounds& bounds);

/// Parallel, with the pixel centres at `through` + (i right + j up) spacing for whole numbers i and
/// j (right and up of length 1), in a window of pixels x pixels. An even window has the middle of
/// four pixels in its middle, an odd one the pixel of `through`.
HardView viewOnPixels(const std::string& name, int pixels, const Vec3& through, const Vec3& right,
  const Vec3& up, double spacing);

/// The eye at a point, looking along the direction in perspective.
HardView viewFrom(const std::string& name, const std::function<Vec3(vtkUnstructuredGrid*)>& eye,
  const Vec3& direction, const Vec3& up, double angle);

/// The view in a window of pixels x pixels. Of a view that is meant for a larger window it is the
/// middle, with the same rays: in a window that is one pixel smaller if else there were a ray
/// between two of them.
HardView inSmallWindow(const HardView& view, int pixels);
} // namespace tetmarch::testing

#endif
