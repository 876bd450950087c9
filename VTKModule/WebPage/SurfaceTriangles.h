// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The arrays of a surface: points, normals, colours and triangles.
#ifndef TetMarchWebPageSurfaceTriangles_h
#define TetMarchWebPageSurfaceTriangles_h

namespace tetmarch
{

struct OpaqueSurface;
struct Surface;

/**
 * Sets the matrix and the arrays of a surface whose material is set. Points are repeated for each
 * cell where the colours or the normals are those of cells. Positions are relative to the middle
 * of the bounds. Triangles with a point that is not finite are left out.
 */
void addTriangles(const OpaqueSurface& drawn, Surface& surface);

} // namespace tetmarch

#endif
