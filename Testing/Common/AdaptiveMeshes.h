// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief An adaptive mesh, and the same in cells of its finest size
 */
#ifndef tetmarch_testing_AdaptiveMeshes_h
#define tetmarch_testing_AdaptiveMeshes_h

#include "GridBuilder.h"

#include "vtkSmartPointer.h"

class vtkOverlappingAMR;

namespace tetmarch::testing
{
/// The unit cube in 4^3 cells, some of them refined twice, in blocks that meet coarse ones, each
/// other and the border. Cell scalars "c" by the middle of each cell.
vtkSmartPointer<vtkOverlappingAMR> adaptiveMesh(const Field& field);
/// Its finest cells, those of each level.
constexpr std::array<int, 3> LeavesOfAdaptiveMesh{ { 51, 84, 160 } };
/// The unit cube in 16^3 hexahedra, each with the scalar of the finest cell of adaptiveMesh()
/// there.
Grid evenMesh(const Field& field);
} // namespace tetmarch::testing

#endif
