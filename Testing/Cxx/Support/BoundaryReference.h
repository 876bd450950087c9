// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief By which boundary face the ray of each pixel enters, by looking at all of them
 */
#ifndef tetmarch_testing_BoundaryReference_h
#define tetmarch_testing_BoundaryReference_h

#include "Scene.h"

namespace tetmarch::testing
{
struct BoundaryPixel
{
  int Face = -1; ///< of the reference's Faces; -1: none
  Vec3 Shares{}; ///< barycentric coordinates of the entry, by the face's vertices
};

struct BoundaryReference
{
  std::vector<std::array<unsigned int, 3>> Faces; ///< of the boundary: their vertices
  std::vector<BoundaryPixel> Pixels;              ///< rows from the bottom of the viewport
};

/// Of a scene as it stands, in double precision and without any of what the march searches by: a
/// ray is in the mesh where the near plane begins it if the next face that it meets lets it out.
/// Depths of opaque geometry: one a pixel, or empty.
BoundaryReference boundaryViewOf(Scene& scene, const std::vector<float>& depths = {});
} // namespace tetmarch::testing

#endif
