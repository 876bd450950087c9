// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Entries/VisiblePartFinder.h"
#include "Parallel/ParallelFor.h"

namespace tetmarch
{

VisiblePart findVisiblePart(const TetMesh& mesh, const VisibleScalars& shown)
{
  VisiblePartFinder finder;
  finder.update(mesh, shown, { 1 });
  return finder.takePart();
}

void linkVisiblePart(const TetMesh& mesh, VisiblePart& part)
{
  part.Links.resize(part.Faces.size());
  parallelFor(0, static_cast<vtkIdType>(part.Faces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        part.Links[i] = mesh.Links[part.Faces[i][3]];
      }
    });
}

} // namespace tetmarch
