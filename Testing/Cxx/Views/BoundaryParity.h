// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The view modes of the boundary beside the reference, pixel by pixel
 */
#ifndef tetmarch_testing_BoundaryParity_h
#define tetmarch_testing_BoundaryParity_h

#include "BoundaryScene.h"

namespace tetmarch::testing
{
/// Returns how many pixels inside the silhouette of the boundary were compared. Where the
/// rasteriser, or float, takes the face beside the reference's, the pixel is on an edge of both:
/// rarely.
int expectAsReference(BoundaryScene& scene, bool withOpaque = false);
} // namespace tetmarch::testing

#endif
