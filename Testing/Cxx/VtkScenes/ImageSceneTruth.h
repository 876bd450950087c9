// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What a pixel of a scene with an image shows by the ground truth
 */
#ifndef tetmarch_testing_ImageSceneTruth_h
#define tetmarch_testing_ImageSceneTruth_h

#include "ImageSceneRays.h"
#include "LatticeTruth.h"

#include <memory>

namespace tetmarch::testing
{
/// Reads data, property, mapper, matrix and camera of a scene that has been drawn: all blend modes,
/// all components, cropping, clipping planes, window and level. No light and no gradient opacity.
/// Lengths are those of the data, whatever the matrix is.
class ImageSceneTruth
{
public:
  ImageSceneTruth(const ImageStage& stage, vtkDataSet* data, int width, int height);

  /// Premultiplied, in the middle of the pixel. A part of a segment of several components is 1/256
  /// of it.
  std::array<double, 4> at(int x, int y) const;

private:
  using Rgba = std::array<double, 4>;

  void readScalars(vtkDataSet* data);
  Rgba coloured(double scalar) const;
  Rgba composite(const PixelRay& ray) const;
  Rgba components(const PixelRay& ray) const;
  Rgba extreme(const PixelRay& ray, bool greatest) const;
  Rgba sum(const PixelRay& ray, bool averages) const;
  Rgba slice(const PixelRay& ray) const;
  Rgba surfaces(const PixelRay& ray) const;

  ImageStage Stage;
  ImageSceneRays Rays;
  OpticalModel Model;
  SegmentIntegral Optics;
  std::vector<std::unique_ptr<LatticeTruth>> Truths; // one a component that is drawn
  double Range[2] = { 0.0, 1.0 };
};

/// The picture and the truth over a few hundred pixels in which either has something: of RGB.
Difference differenceFrom(const ImageSceneTruth& truth, const Image& picture, int every = 6);
} // namespace tetmarch::testing

#endif
