// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "View/RayPoints.h"

#include "View/FittedDepths.h"
#include "View/View.h"

#include "vtkMatrix4x4.h"

#include <cmath>

namespace tetmarch
{
namespace
{

// From the inverse of a matrix: the transformation of clip x and y to the point at that clip depth.
std::array<double, 16> pointsAtDepth(double depth, std::array<double, 16> inverse)
{
  for (int r = 0; r < 4; ++r)
  {
    inverse[4 * r + 3] += depth * inverse[4 * r + 2];
  }
  return inverse;
}

std::array<double, 16> inverted(const std::array<double, 16>& matrix)
{
  std::array<double, 16> inverse;
  vtkMatrix4x4::Invert(matrix.data(), inverse.data());
  return inverse;
}

} // namespace

std::array<double, 16> rayPoints(const View& view, const VolumeFrame& frame)
{
  const auto& eye = view.Eye;
  const double distance = std::hypot(eye[0], eye[1], eye[2]);
  if (eye[3] * 2.0 > distance)
  {
    // From an eye in the volume to its far end, so that the direction has digits.
    const double depth = view.CutsNearPlane ? 1.0 : -1.0;
    return pointsAtDepth(depth, inverted(fittedDepths(view, frame)));
  }
  // The plane through the centre that faces the eye replaces the planes of equal depth, which may
  // be nearly parallel to the rays if the matrix is not a similarity.
  std::array<double, 16> matrix = view.NormalizedToClip;
  for (int k = 0; k < 3; ++k)
  {
    matrix[8 + k] = eye[k] / distance;
  }
  matrix[11] = 0.0;
  return inverted(matrix);
}

} // namespace tetmarch
