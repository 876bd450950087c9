// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curved/StraightGrid.h"

#include "Caching/WithinMemory.h"
#include "Curved/CurvedShape.h"
#include "Curved/OutputCells.h"
#include "Curved/Tessellation.h"
#include "Scalars/GhostArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

// That of vtkTetMarchTessellator: rounding is far below it.
constexpr double LeastTolerance = 1e-6;

bool hasCurvedCells(vtkUnstructuredGrid* grid)
{
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (curvedShape(grid->GetCellType(cell)))
    {
      return true;
    }
  }
  return false;
}

// The ghosts of cells, with those of points: these are lost when cells are cut.
vtkSmartPointer<vtkUnsignedCharArray> ghostsOf(vtkUnstructuredGrid* grid)
{
  const GhostArrays given = ghostArraysOf(grid);
  if (!hasAny(given.OfPoints, HidingPoint))
  {
    return given.OfCells;
  }
  const std::vector<bool> hides = cellsOfHiddenPoints(grid, given.OfPoints);
  auto ghosts = vtkSmartPointer<vtkUnsignedCharArray>::New();
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const unsigned char ghost = given.OfCells ? given.OfCells->GetValue(cell) : 0;
    ghosts->InsertNextValue(hides[cell] ? ghost | vtkDataSetAttributes::HIDDENCELL : ghost);
  }
  return ghosts;
}

// The cells, and the arrays that a picture needs.
vtkSmartPointer<vtkUnstructuredGrid> drawnPart(
  vtkUnstructuredGrid* grid, vtkDataArray* scalars, bool ofCells)
{
  auto drawn = vtkSmartPointer<vtkUnstructuredGrid>::New();
  drawn->CopyStructure(grid);
  drawn->GetCellData()->SetHigherOrderDegrees(grid->GetCellData()->GetHigherOrderDegrees());
  drawn->GetPointData()->SetRationalWeights(grid->GetPointData()->GetRationalWeights());
  drawn->GetAttributes(ofCells ? vtkDataObject::CELL : vtkDataObject::POINT)->SetScalars(scalars);
  drawn->GetCellData()->AddArray(ghostsOf(grid));
  return drawn;
}

std::vector<vtkIdType> cellsOf(vtkUnstructuredGrid* cut)
{
  auto* of = vtkIdTypeArray::SafeDownCast(cut->GetCellData()->GetArray(OriginalCells));
  return { of->GetPointer(0), of->GetPointer(0) + of->GetNumberOfValues() };
}

} // namespace

std::string straighten(vtkUnstructuredGrid* grid, vtkDataArray* scalars, bool ofCells,
  const CurvedOptions& options, const Progress& progress, StraightGrid& straight)
{
  const double kept = std::max(options.Tolerance, LeastTolerance);
  straight = {};
  if (!hasCurvedCells(grid))
  {
    return {};
  }
  std::string error;
  const std::string shortage = withinMemory("the tetrahedra of curved cells within this tolerance",
    [&]
    {
      const auto drawn = drawnPart(grid, scalars, ofCells);
      const auto report = [&](double share)
      {
        straight.Stopped = progress && !progress(share);
        return !straight.Stopped;
      };
      auto cut = vtkSmartPointer<vtkUnstructuredGrid>::New();
      CurvedDeparture departure;
      error = tessellate(drawn, toleranceOf(grid, ofCells ? nullptr : scalars, kept, kept), report,
        cut, options.MeasuresDeparture ? &departure : nullptr);
      if (error.empty() && !straight.Stopped)
      {
        vtkDataSetAttributes* of =
          cut->GetAttributes(ofCells ? vtkDataObject::CELL : vtkDataObject::POINT);
        straight = { cut, of->GetScalars(), cellsOf(cut), departure, options.MeasuresDeparture };
      }
    });
  return error.empty() ? shortage : error;
}

} // namespace tetmarch
