// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/PackedCells.h"

#include "vtkSMPTools.h"

namespace tetmarch
{

std::vector<PackedCell> packCells(const TetMesh& mesh)
{
  std::vector<PackedCell> cells(mesh.Tets.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(cells.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType tet = first; tet < last; ++tet)
      {
        cells[tet] = packedCell(mesh, static_cast<std::size_t>(tet));
      }
    });
  return cells;
}

} // namespace tetmarch
