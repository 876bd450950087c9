// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How one cube of a lattice falls into cells
 *
 * Corner b of a cube lies at x = bit 0, y = bit 1, z = bit 2 of b. The diagonal of a face that is
 * cut in two triangles runs from its lowest corner to its highest, so that the cubes on both sides
 * agree.
 */
#ifndef tetmarch_testing_CubeTopology_h
#define tetmarch_testing_CubeTopology_h

namespace tetmarch::testing
{
/// The corners in the order of VTK_HEXAHEDRON; VTK_VOXEL takes them as they are.
inline constexpr int HexCorners[8] = { 0, 1, 3, 2, 4, 5, 7, 6 };

/// Six tetrahedra about the diagonal 0-7, one for each order of the axes (Kuhn 1960), all with
/// positive volume.
inline constexpr int KuhnTets[6][4] = { { 0, 1, 3, 7 }, { 0, 2, 6, 7 }, { 0, 4, 5, 7 },
  { 0, 5, 1, 7 }, { 0, 3, 2, 7 }, { 0, 6, 4, 7 } };

/// The faces -x, +x, -y, +y, -z, +z, normal outwards, lowest corner first and so the highest third.
inline constexpr int CubeFaces[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 },
  { 2, 6, 7, 3 }, { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };

/// Two wedges along z. Triangle 0-1-2 of a VTK_WEDGE has its normal outwards.
inline constexpr int CubeWedges[2][6] = { { 0, 3, 1, 4, 7, 5 }, { 0, 2, 3, 4, 6, 7 } };
} // namespace tetmarch::testing

#endif
