// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/PackedCells.h"

#include "Parallel/ParallelFor.h"

namespace tetmarch
{

void packCells(
  const TetMesh& mesh, std::size_t begin, std::size_t end, std::vector<PackedCell>& cells)
{
  cells.resize(end - begin);
  parallelFor(0, static_cast<vtkIdType>(cells.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        cells[i] = packedCell(mesh, begin + static_cast<std::size_t>(i));
      }
    });
}

} // namespace tetmarch
