// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SameMesh.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <cstring>

namespace
{
/// Both may be null. Arrays of other types differ, even if their values don't.
bool AreEqual(vtkDataArray* a, vtkDataArray* b)
{
  if (a == b || !a || !b)
  {
    return a == b;
  }
  return a->GetDataType() == b->GetDataType() && a->HasStandardMemoryLayout() &&
         b->HasStandardMemoryLayout() && a->GetNumberOfValues() == b->GetNumberOfValues() &&
         (a->GetNumberOfValues() == 0 || std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
                                           static_cast<std::size_t>(a->GetNumberOfValues()) *
                                             static_cast<std::size_t>(a->GetDataTypeSize())) == 0);
}

/// Faces of polyhedra are not looked at: such cells count as different.
bool HaveSameTypes(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  for (vtkIdType i = 0; i < a->GetNumberOfCells(); ++i)
  {
    const int type = a->GetCellType(i);
    if (type == VTK_POLYHEDRON || type != b->GetCellType(i))
    {
      return false;
    }
  }
  return true;
}

bool HaveSameCells(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  return a->GetNumberOfCells() == b->GetNumberOfCells() &&
         AreEqual(a->GetCells()->GetOffsetsArray(), b->GetCells()->GetOffsetsArray()) &&
         AreEqual(a->GetCells()->GetConnectivityArray(), b->GetCells()->GetConnectivityArray()) &&
         HaveSameTypes(a, b);
}
} // namespace

bool tetmarch::HasSameMesh(vtkDataObject* a, vtkDataObject* b)
{
  auto* one = vtkUnstructuredGrid::SafeDownCast(a);
  auto* other = vtkUnstructuredGrid::SafeDownCast(b);
  if (one == other || !one || !other)
  {
    return one && one == other;
  }
  return AreEqual(one->GetPoints()->GetData(), other->GetPoints()->GetData()) &&
         HaveSameCells(one, other);
}
