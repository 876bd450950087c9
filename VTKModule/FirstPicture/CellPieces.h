// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells of any type as tetrahedra with values at their corners.
#ifndef TetMarchFirstPictureCellPieces_h
#define TetMarchFirstPictureCellPieces_h

#include "FirstPicture/DrawnArray.h"
#include "Geometry/Vector3.h"
#include "Scalars/GhostArrays.h"

#include <array>
#include <memory>
#include <vector>

namespace tetmarch
{

struct PieceCorner
{
  Vector3 Point;
  double Value;
};

// A tetrahedron of a cell. Values are linear in it.
struct ValuedPiece
{
  std::array<PieceCorner, 4> Corners;
  double Volume;
};

// Decomposes 3D cells of one valid block (checkData) into tetrahedra: polyhedra by fans around
// their centre, others by vtkCell::Triangulate().
class CellCutting
{
public:
  CellCutting(vtkDataSet* block, const DrawnValues& values);
  ~CellCutting();
  CellCutting(const CellCutting&) = delete;
  CellCutting& operator=(const CellCutting&) = delete;

  // Flat, ghost and hidden cells have no pieces.
  const std::vector<ValuedPiece>& cut(vtkIdType cell);

private:
  struct Scratch;

  PieceCorner cornerAt(vtkIdType point, vtkIdType cell) const;
  void addPiece(const std::array<PieceCorner, 4>& corners);
  void cutPolyhedron(vtkIdType cell);
  void cutByVTK(vtkIdType cell, int type);

  vtkDataSet* Block;
  const DrawnValues& Values;
  vtkUnsignedCharArray* Ghosts; // null without
  std::vector<ValuedPiece> Pieces;
  std::unique_ptr<Scratch> Own;
};

} // namespace tetmarch

#endif
