// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/CellPieces.h"

#include "Input/CellKind.h"
#include "Input/GridVersions.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{

struct CellCutting::Scratch
{
  vtkNew<vtkGenericCell> Cell;
  vtkNew<vtkIdList> Ids;
  vtkNew<vtkPoints> Points;
};

CellCutting::CellCutting(vtkDataSet* block, const DrawnValues& values)
  : Block(block)
  , Values(values)
  , Ghosts(ghostArraysOf(block).OfCells)
  , Own(std::make_unique<Scratch>())
{
}

CellCutting::~CellCutting() = default;

PieceCorner CellCutting::cornerAt(vtkIdType point, vtkIdType cell) const
{
  PieceCorner corner;
  this->Block->GetPoint(point, corner.Point.data());
  corner.Value = this->Values.at(this->Values.ofCells() ? cell : point);
  return corner;
}

void CellCutting::addPiece(const std::array<PieceCorner, 4>& corners)
{
  const Vector3& apex = corners[3].Point;
  const double volume = std::abs(dot(corners[0].Point - apex,
                          cross(corners[1].Point - apex, corners[2].Point - apex))) /
                        6;
  if (volume > 0 && std::isfinite(volume))
  {
    this->Pieces.push_back({ corners, volume });
  }
}

// As vtkUnstructuredGrid::GetFaceStream() has it: number of faces, then of each its points.
void CellCutting::cutPolyhedron(vtkIdType cell)
{
  this->Block->GetCellPoints(cell, this->Own->Ids);
  PieceCorner middle{};
  const auto count = static_cast<double>(this->Own->Ids->GetNumberOfIds());
  for (const vtkIdType point : *this->Own->Ids)
  {
    const PieceCorner corner = this->cornerAt(point, cell);
    add(1 / count, corner.Point, middle.Point);
    middle.Value += corner.Value / count;
  }
  static_cast<vtkUnstructuredGrid*>(this->Block)->GetFaceStream(cell, this->Own->Ids);
  const vtkIdType* at = this->Own->Ids->GetPointer(0);
  for (vtkIdType faces = *at++; faces > 0; --faces)
  {
    const vtkIdType corners = *at++;
    for (vtkIdType i = 1; i + 1 < corners; ++i)
    {
      this->addPiece({ { this->cornerAt(at[0], cell), this->cornerAt(at[i], cell),
        this->cornerAt(at[i + 1], cell), middle } });
    }
    at += corners;
  }
}

void CellCutting::cutByVTK(vtkIdType cell, int type)
{
  vtkIdList* ids = this->Own->Ids;
  this->Block->GetCell(cell, this->Own->Cell);
  this->Own->Cell->Triangulate(0, ids, this->Own->Points);
  if (type == VTK_CONVEX_POINT_SET && ConvexPointSetsCountLocally)
  {
    std::transform(ids->begin(), ids->end(), ids->begin(),
      [this](vtkIdType corner) { return this->Own->Cell->GetPointId(corner); });
  }
  const vtkIdType* at = ids->GetPointer(0);
  for (vtkIdType i = 0; i + 4 <= ids->GetNumberOfIds(); i += 4)
  {
    this->addPiece({ { this->cornerAt(at[i], cell), this->cornerAt(at[i + 1], cell),
      this->cornerAt(at[i + 2], cell), this->cornerAt(at[i + 3], cell) } });
  }
}

const std::vector<ValuedPiece>& CellCutting::cut(vtkIdType cell)
{
  this->Pieces.clear();
  if (this->Ghosts && (this->Ghosts->GetValue(cell) & HidingCell) != 0)
  {
    return this->Pieces;
  }
  const int type = this->Block->GetCellType(cell);
  switch (cellKinds()[static_cast<unsigned char>(type)].Cut)
  {
    case CellCut::Polyhedron:
      this->cutPolyhedron(cell);
      break;
    case CellCut::Tetrahedron:
    case CellCut::Pieces:
    case CellCut::ByVTK:
      this->cutByVTK(cell, type);
      break;
    default: // the mapper skips them
      break;
  }
  return this->Pieces;
}

} // namespace tetmarch
