// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Grids cut into pieces, one for each process.
#ifndef TetMarchTestingPieces_h
#define TetMarchTestingPieces_h

#include "GridBuilder.h"

#include <functional>

namespace tetmarch
{
namespace testing
{

/** The process that has a cell. */
using Partition = std::function<int(vtkIdType cell)>;

/** Each cell anywhere: the worst case. */
Partition randomPartition(int processes, unsigned int seed);

/** The cells of one process, with the points that they use, which have other numbers than in the
 * grid. */
Grid pieceOf(vtkUnstructuredGrid* grid, const Partition& partition, int process);

} // namespace testing
} // namespace tetmarch

#endif
