// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MovedCells.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <cmath>

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

// Too long for the first block that the reader takes, and hardly to be compressed.
vtkSmartPointer<vtkUnstructuredGrid> sampleOfCells()
{
  constexpr int count = 1000;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->AllocateExact(count, 4 * count);
  for (int cell = 0; cell < count; ++cell)
  {
    vtkIdType corners[4];
    for (vtkIdType& corner : corners)
    {
      const double place = static_cast<double>(points->GetNumberOfPoints());
      corner =
        points->InsertNextPoint(std::sin(place), std::sin(1.7 * place), std::sin(2.3 * place));
    }
    grid->InsertNextCell(VTK_TETRA, 4, corners);
  }
  grid->SetPoints(points);
  return grid;
}

std::string findFault()
{
  const auto sent = sampleOfCells();
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->WriteToOutputStringOn();
  writer->SetCompressorTypeToLZ4();
  writer->EncodeAppendedDataOff();
  writer->SetInputData(sent);
  writer->Write();
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(writer->GetOutputString());
  const int displaysWarnings = vtkObject::GetGlobalWarningDisplay();
  vtkObject::GlobalWarningDisplayOff(); // what is wrong is told by what is returned
  reader->Update();
  vtkObject::SetGlobalWarningDisplay(displaysWarnings);
  return reader->GetOutput()->GetNumberOfCells() == sent->GetNumberOfCells()
           ? ""
           : "VTK loses the cells that it sends to another process, as that of ParaView 5.11 does "
             "with the expat library of Debian 12 since 2.5.0-1+deb12u2.";
}

} // namespace

const std::string& faultOfMoves()
{
  static const std::string fault = findFault();
  return fault;
}

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

} // namespace tetmarch
