// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The picture that the CPU reference makes of a scene, and how far the GL's is from it
 */
#ifndef tetmarch_testing_CpuReference_h
#define tetmarch_testing_CpuReference_h

#include "Scene.h"

#include "Diagnostics/MarchCounters.h"
#include "Reference/IncomingLight.h"

namespace tetmarch::testing
{
enum class Precision
{
  Float,
  Double
};

struct ReferencePicture
{
  Image Picture;
  std::vector<float> ErrorBounds; ///< of each pixel
  MarchCounters Counters;
};

/// Of the scene as its last frame left it, with the same tables, accuracy level, blend mode and
/// effects. Depths of opaque geometry: one a pixel, or empty.
ReferencePicture referenceOf(Scene& scene, const std::vector<float>& depths = {},
  Precision precision = Precision::Double, LightAt light = LightAt::Vertices);

/// The pixels of a picture, by whether they and their eight neighbours see the mesh: all of them,
/// none, or some. Near the silhouette a rasterised entry may be lost or won, or moved by a
/// hundredth of a pixel, which can be much of a short chord or of a boundary seen edge-on.
struct Regions
{
  Mask Inside;
  Mask Outside;
  Mask Rim;
};
Regions regionsOf(Scene& scene, const std::vector<float>& depths = {});

/// Renders the scene and compares with the reference in double and in float: inside the silhouette
/// at most 2/255 in each pixel and 0.3/255 in RMS, nothing outside it, over 2/255 in at most every
/// 50th pixel of the rim; no ray lost or stopped, and of the
/// entries that the rasteriser named at most 20 refused. Prints the figures.
void expectParity(Scene& scene, const std::vector<float>& depths = {});
/// The same with the depths that the frame left in the window.
void expectParityWithOpaque(Scene& scene);
/// Expects that light which is sampled at random points of rays is that which is computed at every
/// face of a ray, to 1.5/255 RMS, and that the picture `without` it differs. Prints the difference.
void expectLightAlongRays(Scene& scene, const Image& drawn, const Image& without);
} // namespace tetmarch::testing

#endif
