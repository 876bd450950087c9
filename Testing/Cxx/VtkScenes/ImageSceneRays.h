// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The rays of a scene with an image, and which parts of each are seen
 */
#ifndef tetmarch_testing_ImageSceneRays_h
#define tetmarch_testing_ImageSceneRays_h

#include "ImageScene.h"
#include "Unprojection.h"

namespace tetmarch::testing
{
/// In coordinates of the data.
struct PixelRay
{
  Vec3 Origin;
  Vec3 Direction;                           ///< of length 1
  std::vector<std::array<double, 2>> Parts; ///< lengths, front to back
};

/// Reads camera, matrix, clipping planes and cropping of a scene that has been drawn.
class ImageSceneRays
{
public:
  ImageSceneRays(const ImageStage& stage, int width, int height);

  /// Through the middle of the pixel: what is between the near and the far plane and not cut away.
  PixelRay at(int x, int y) const;

private:
  void crop(PixelRay& ray) const;

  ImageStage Stage;
  int Width;
  int Height;
  Unprojection ToWorld;
  vtkNew<vtkMatrix4x4> ToData;
};
} // namespace tetmarch::testing

#endif
