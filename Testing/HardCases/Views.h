// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Cameras for hard cases, placed by the bounding box of the grid
 */
#ifndef tetmarch_testing_HardCaseViews_h
#define tetmarch_testing_HardCaseViews_h

#include "HardCase.h"

namespace tetmarch::testing
{
/// Centre and radius of the box of the grid.
struct Ball
{
  Vec3 Centre;
  double Radius;
};
Ball ballOf(vtkUnstructuredGrid* grid);

/// Perspective, from a direction, the given number of radii away; the ball fills the height of the
/// picture (share 1), whatever the distance.
HardView perspectiveFrom(
  const std::string& name, const Vec3& direction, double radiiAway, double share = 0.9);

/// Perspective of a given angle in degrees, radiiAway from the centre.
HardView perspectiveOfAngle(
  const std::string& name, const Vec3& direction, double radiiAway, double angle);

/// Parallel; half the height of the picture is the radius times scale.
HardView parallelAlong(const std::string& name, const Vec3& direction, double scale = 1.1);

/// The eye at a point of the grid's own frame, looking along a direction, 60 degrees wide; what
/// lies before 1e-3 radii is cut off.
HardView eyeAt(const std::string& name, const Vec3& eye, const Vec3& direction);
} // namespace tetmarch::testing

#endif
