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
  int Face = -1;       ///< of the reference's Faces; -1: none
  Vec3 Barycentrics{}; ///< of the entry, by the face's vertices
};

struct BoundaryReference
{
  std::vector<std::array<unsigned int, 3>> Faces; ///< of the boundary: their vertices
  std::vector<BoundaryPixel> Pixels;              ///< rows from the bottom of the viewport
};

/// The boundary view of a scene, in double precision and by all faces, without links or hierarchy.
/// A ray begins inside of the mesh if the first face behind the near plane is one that it leaves
/// by. Depths of opaque geometry: one a pixel, or empty.
BoundaryReference boundaryViewOf(Scene& scene, const std::vector<float>& depths = {});
} // namespace tetmarch::testing

#endif
