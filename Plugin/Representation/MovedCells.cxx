// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MovedCells.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVersionMacros.h"

namespace tetmarch
{
namespace
{

constexpr const char* HiddenName = "TetMarchHidden";

vtkSmartPointer<vtkUnsignedCharArray> copyUnder(
  const char* name, vtkUnsignedCharArray* values, vtkIdType count)
{
  auto copy = vtkSmartPointer<vtkUnsignedCharArray>::New();
  if (values && values->GetNumberOfComponents() == 1 && values->GetNumberOfTuples() == count)
  {
    copy->DeepCopy(values);
  }
  else
  {
    copy->SetNumberOfTuples(count);
    copy->FillValue(0);
  }
  copy->SetName(name);
  return copy;
}

// All processes have this array, also where nothing is hidden: VTK drops one that some lack.
void packHidden(vtkDataSetAttributes* attributes, vtkIdType count, unsigned char ghost)
{
  const char* ghosts = vtkDataSetAttributes::GhostArrayName();
  const auto hidden =
    copyUnder(HiddenName, vtkUnsignedCharArray::SafeDownCast(attributes->GetArray(ghosts)), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    hidden->SetValue(i, hidden->GetValue(i) & static_cast<unsigned char>(~ghost));
  }
  attributes->AddArray(hidden);
}

void unpackHidden(vtkDataSetAttributes* attributes, vtkIdType count)
{
  const char* ghosts = vtkDataSetAttributes::GhostArrayName();
  const auto hidden = vtkSmartPointer<vtkUnsignedCharArray>(
    vtkUnsignedCharArray::SafeDownCast(attributes->GetArray(HiddenName)));
  attributes->RemoveArray(ghosts);
  attributes->RemoveArray(HiddenName);
  if (hidden)
  {
    attributes->AddArray(copyUnder(ghosts, hidden, count));
  }
}

vtkSmartPointer<vtkUnstructuredGrid> copyOf(vtkUnstructuredGrid* grid)
{
  auto copy = vtkSmartPointer<vtkUnstructuredGrid>::New();
  copy->ShallowCopy(grid);
  return copy;
}

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
// Readers of ParaView 5.11 at times leave arrays of the faces of polyhedra that are empty. Where
// VTK picks the cells to be sent, it reads beyond their end.
void dropEmptyFaces(vtkUnstructuredGrid* grid)
{
  vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  bool hasPolyhedra = false;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells() && !hasPolyhedra; ++cell)
  {
    hasPolyhedra = types->GetValue(cell) == VTK_POLYHEDRON;
  }
  if (!hasPolyhedra && grid->GetNumberOfCells() > 0)
  {
    grid->SetCells(types, grid->GetCells());
  }
}
#else
// Faces of polyhedra are no arrays of numbers any more.
void dropEmptyFaces(vtkUnstructuredGrid* /*grid*/) {}
#endif

} // namespace

vtkSmartPointer<vtkUnstructuredGrid> packCells(vtkUnstructuredGrid* grid)
{
  auto packed = copyOf(grid);
  dropEmptyFaces(packed);
  packHidden(
    packed->GetCellData(), packed->GetNumberOfCells(), vtkDataSetAttributes::DUPLICATECELL);
  packHidden(
    packed->GetPointData(), packed->GetNumberOfPoints(), vtkDataSetAttributes::DUPLICATEPOINT);
  return packed;
}

vtkSmartPointer<vtkUnstructuredGrid> unpackCells(vtkUnstructuredGrid* grid)
{
  auto unpacked = copyOf(grid);
  unpackHidden(unpacked->GetCellData(), unpacked->GetNumberOfCells());
  unpackHidden(unpacked->GetPointData(), unpacked->GetNumberOfPoints());
  return unpacked;
}

vtkUnstructuredGrid* MadeGrid::of(vtkUnstructuredGrid* grid)
{
  if (this->From != grid || this->Time != grid->GetMTime())
  {
    this->From = grid;
    this->Time = grid->GetMTime();
    this->Made = this->Make(grid);
  }
  return this->Made;
}

} // namespace tetmarch
