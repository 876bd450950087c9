// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Random rays and functions over [0, 1] by which the ground truths are tested
 */
#ifndef tetmarch_testing_SelfTestModels_h
#define tetmarch_testing_SelfTestModels_h

#include "LatticeGrids.h"
#include "SegmentIntegral.h"

#include <cmath>

namespace tetmarch::testing
{
inline Vec3 randomPoint(std::mt19937& generator, double low, double high)
{
  Vec3 p;
  for (double& x : p)
  {
    x = low + (high - low) * uniform(generator);
  }
  return p;
}

inline Vec3 randomDirection(std::mt19937& generator)
{
  Vec3 d;
  double length;
  do
  {
    d = randomPoint(generator, -1.0, 1.0);
    length = std::hypot(d[0], d[1], d[2]);
  } while (length > 1.0 || length < 0.1);
  return d;
}

/// Colour from (r0, g0, b0) at 0 to (r1, g1, b1) at 1 and opacity from a0 to a1.
inline OpticalModel ramps(const Vec3& c0, const Vec3& c1, double a0, double a1)
{
  return opticalModelOf({ { { 0.0, c0[0], c0[1], c0[2] } }, { { 1.0, c1[0], c1[1], c1[2] } } },
    { { { 0.0, a0 } }, { { 1.0, a1 } } });
}

/// Spikes, plateaus, a midpoint and a sharp bend.
inline OpticalModel spiky()
{
  OpticalModel model;
  model.Colour = vtkSmartPointer<vtkColorTransferFunction>::New();
  model.Colour->AddRGBPoint(0.0, 0.1, 0.2, 0.9);
  model.Colour->AddRGBPoint(0.3, 0.9, 0.8, 0.1, 0.3, 0.0);
  model.Colour->AddRGBPoint(0.7, 0.2, 0.9, 0.2, 0.6, 0.4);
  model.Colour->AddRGBPoint(1.0, 1.0, 0.1, 0.1);
  model.Opacity = vtkSmartPointer<vtkPiecewiseFunction>::New();
  model.Opacity->AddPoint(0.0, 0.0);
  model.Opacity->AddPoint(0.25, 0.05);
  model.Opacity->AddPoint(0.26, 0.9);
  model.Opacity->AddPoint(0.27, 0.05, 0.3, 0.5);
  model.Opacity->AddPoint(0.8, 0.6);
  model.Opacity->AddPoint(1.0, 0.2);
  model.UnitDistance = 0.1;
  return model;
}
} // namespace tetmarch::testing

#endif
