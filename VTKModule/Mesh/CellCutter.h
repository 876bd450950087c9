// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cuts one cell into tetrahedra.
#ifndef TetMarchMeshCellCutter_h
#define TetMarchMeshCellCutter_h

#include "Input/CellKind.h"
#include "Input/CellShapes.h"
#include "Input/HigherOrderCheck.h"
#include "Mesh/Decomposition.h"

#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <map>

class vtkCellArray;

namespace tetmarch
{

/** How points are numbered; empty lists: by their ids. */
struct PointNumbers
{
  std::vector<Id> Firsts; // the point in place of each one (CoincidentPoints.h)
  std::vector<Id> Order;  // the rank of each point
};

/**
 * Cuts cells of a grid that passed checkGrid() by the rules of decompose(), and appends the
 * tetrahedra to Result. Ids of centres follow those of the grid's points, in the order of their
 * cells. Each thread has its own cutter.
 */
class CellCutter
{
public:
  /** The numbers must outlive the cutter. */
  CellCutter(vtkUnstructuredGrid* grid, const PointNumbers& numbers);

  Decomposition Result;

  void cut(vtkIdType cell, int type);

private:
  using Point = std::array<double, 3>;

  void cutPieces(vtkIdType cell, const std::vector<CellPiece>& pieces);
  /** Whether it is a cell of linear parts. */
  bool cutParts(vtkIdType cell, int type);
  const LinearParts& partsOf(int type, const CellDegrees& degrees);
  void cutPolyhedron(vtkIdType cell);
  void cutByVTK(vtkIdType cell, int type);

  /** Triangulates the face from its smallest corner. */
  void fan();
  void cone(vtkIdType cell, Id apex);
  void coneFromBestPoint(vtkIdType cell);
  Id bestPoint(vtkIdType cell, Id least);
  void add(vtkIdType cell, const std::array<Id, 4>& tet);

  /** Whether the point lies on the inner side of every triangle, as the mean of the cell's points
   * does. */
  bool seesAllFaces(Id apex);
  void findMean();
  Id centerOf(vtkIdType cell);

  /** Compares points by their rank in the order, or by id. */
  bool isLess(Id a, Id b) const
  {
    const std::vector<Id>& order = this->Numbers.Order;
    return order.empty() ? a < b : order[a] < order[b];
  }
  Id numberOf(vtkIdType point) const
  {
    const std::vector<Id>& firsts = this->Numbers.Firsts;
    return firsts.empty() ? static_cast<Id>(point) : firsts[static_cast<std::size_t>(point)];
  }
  void readPoints(vtkIdType cell);
  Id point(vtkIdType i) const { return static_cast<Id>(this->PointIds->GetId(i)); }
  Point position(Id id) const;

  vtkUnstructuredGrid* Grid;
  const PointNumbers& Numbers;
  vtkCellArray* CellArray;
  vtkPoints* Points;
  vtkIdType NumberOfPoints;
  const std::array<CellKind, 256>& Kinds = cellKinds();
  vtkNew<vtkIdList> PointIds;
  vtkNew<vtkIdList> FaceStream;
  vtkNew<vtkGenericCell> Cell;
  vtkNew<vtkIdList> CutIds;
  vtkNew<vtkPoints> CutPoints;
  std::vector<Id> Face;
  std::vector<std::array<Id, 3>> Triangles;
  HigherOrderArrays HigherOrder;
  std::map<std::pair<int, CellDegrees>, LinearParts> Parts; // of cells that were cut
  vtkNew<vtkIdList> PointsOfCell;                           // while parts of it are cut
  bool IsPart = false;
  Point Mean{ { 0, 0, 0 } };
  vtkIdType CenterOfCell = -1; // index among the centres of this cutter
};

} // namespace tetmarch

#endif
