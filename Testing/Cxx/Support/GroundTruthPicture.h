// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The picture of a scene by brute force in world coordinates
 */
#ifndef tetmarch_testing_GroundTruthPicture_h
#define tetmarch_testing_GroundTruthPicture_h

#include "Scene.h"
#include "Unprojection.h"

#include "GroundTruth.h"

namespace tetmarch::testing
{
/// Of a square window, with the property and the camera of the scene, and the tetrahedra in world
/// coordinates. Has nothing in common with the mapper.
inline Image groundTruthPicture(
  Scene& scene, vtkUnstructuredGrid* tetrahedra, ScalarsOf scalars, int side)
{
  OpticalModel model;
  model.Colour = scene.property()->GetRGBTransferFunction();
  model.Opacity = scene.property()->GetScalarOpacity();
  model.UnitDistance = scene.property()->GetScalarOpacityUnitDistance();
  const GroundTruthScene groundTruth(tetrahedra, model, scalars);
  const Unprojection unproject(scene.camera());
  Image image(side, side);
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      const double sx = (x + 0.5) / side * 2.0 - 1.0;
      const double sy = (y + 0.5) / side * 2.0 - 1.0;
      const Vec3 from = unproject(sx, sy, -1.0);
      const Vec3 to = unproject(sx, sy, 1.0);
      const auto rgba =
        groundTruth.integrate(from, { to[0] - from[0], to[1] - from[1], to[2] - from[2] });
      std::copy(rgba.begin(), rgba.end(), image.pixel(x, y));
    }
  }
  return image;
}
} // namespace tetmarch::testing

#endif
