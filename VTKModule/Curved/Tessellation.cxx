// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curved/Tessellation.h"

#include "Curved/CellPieces.h"
#include "Curved/CornerCells.h"
#include "Curved/CurvedCell.h"
#include "Curved/EdgeTable.h"
#include "Curved/OutputCells.h"
#include "Curved/OutputPoints.h"
#include "Input/CellKind.h"
#include "Input/GridVersions.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>

namespace tetmarch
{
namespace
{

// Of the tolerance of distances: middles of edges of different cells that are as near are one.
constexpr double SamePlace = 0.01;
constexpr vtkIdType CellsBetweenProgress = 1000;

struct CutCell
{
  vtkIdType Id;
  const CurvedShape* Shape;
  std::vector<PiecePoint> Corners;
  std::vector<Piece> Pieces;
  EdgeTable InnerEdges; // those in no face
  bool IsWaiting = true;
};

class Tessellator
{
public:
  Tessellator(vtkUnstructuredGrid* grid, const CurvedTolerance& tolerance,
    vtkUnstructuredGrid* output, bool measuresDepartures)
    : Grid(grid)
    , Tolerance(tolerance)
    , Cell(grid, tolerance.Scalars)
    , Points(grid, tolerance.Scalars, output)
    , Output(grid, this->Points, output)
    , MeasuresDepartures(measuresDepartures)
  {
  }

  /** Begins with a cell. */
  void add(vtkIdType cell, const CurvedShape& shape)
  {
    this->Grid->GetCells()->GetCellAtId(cell, this->Ids);
    const auto index = static_cast<std::uint32_t>(this->Cells.size());
    std::vector<PiecePoint> corners;
    for (std::size_t i = 0; i < shape.Corners.size(); ++i)
    {
      corners.push_back(this->Points.copyOf(this->Ids->GetId(static_cast<vtkIdType>(i))));
      this->CellsOfCorners.add(corners.back().Place, index);
    }
    this->Waiting.push_back(index);
    this->Cells.push_back({ cell, &shape, corners, firstPieces(shape, corners), {} });
  }

  /** Returns false if the progress says so. */
  bool refine(const std::function<bool(double)>& progress)
  {
    this->CellsOfCorners.sort();
    for (vtkIdType done = 0; !this->Waiting.empty(); ++done)
    {
      const auto all = static_cast<double>(done) + static_cast<double>(this->Waiting.size());
      if (done % CellsBetweenProgress == 0 && !progress(static_cast<double>(done) / all))
      {
        return false;
      }
      CutCell& cell = this->Cells[this->Waiting.front()];
      this->Waiting.pop_front();
      cell.IsWaiting = false;
      this->Cell.read(cell.Id, *cell.Shape);
      while (this->halve(cell))
      {
      }
    }
    return true;
  }

  void write()
  {
    for (const CutCell& cell : this->Cells)
    {
      for (const Piece& piece : cell.Pieces)
      {
        this->Output.insert(cell.Id, piece);
      }
    }
    this->Output.finish();
  }

  void pass(vtkIdType cell) { this->Output.pass(cell); }

  /** The greatest one of each kind. */
  CurvedDeparture departure()
  {
    CurvedDeparture greatest;
    for (CutCell& cell : this->Cells)
    {
      for (const Piece& piece : cell.Pieces)
      {
        std::array<std::uint32_t, 6> edges;
        std::transform(std::begin(PieceEdges), std::end(PieceEdges), edges.begin(),
          [&](const int* ends)
          { return this->edge(cell, piece[ends[0]], piece[ends[1]]).Departure; });
        const CurvedDeparture departure = departureOf(piece, edges, this->Departures, this->Points);
        greatest.Distance = std::max(greatest.Distance, departure.Distance);
        greatest.Value = std::max(greatest.Value, departure.Value);
      }
    }
    return greatest;
  }

private:
  EdgeTable::Edge& edge(CutCell& cell, const PieceCorner& a, const PieceCorner& b)
  {
    const bool isOuter = (a.Faces & b.Faces) != 0;
    return (isOuter ? this->OuterEdges : cell.InnerEdges).edge(a.Point.Id, b.Point.Id);
  }

  vtkIdType& middle(CutCell& cell, const PieceCorner& a, const PieceCorner& b)
  {
    const bool isOuter = (a.Faces & b.Faces) != 0;
    EdgeTable::Edge& edge = this->edge(cell, a, b);
    vtkIdType& middle = edge.Middle;
    if (middle == EdgeTable::Unknown)
    {
      middle = EdgeTable::Whole;
      EdgeDeparture* departure = this->MeasuresDepartures ? &this->Departure : nullptr;
      if (leavesTolerance(this->Tolerance, a, b, this->Points, this->Cell, this->Place, departure))
      {
        this->setMiddle(cell, a, b, middle);
      }
      else if (departure)
      {
        edge.Departure = this->Departures.add(this->Departure);
      }
    }
    if (middle == EdgeTable::Whole && isOuter && this->Points.isShared())
    {
      this->followOthers(a, b, middle);
    }
    return middle;
  }

  void setMiddle(CutCell& cell, const PieceCorner& a, const PieceCorner& b, vtkIdType& middle)
  {
    const bool isOuter = (a.Faces & b.Faces) != 0;
    if (isOuter && this->Points.isShared() && this->followOthers(a, b, middle))
    {
      return; // its neighbours were woken then
    }
    this->Cell.evaluate(middleOf(a, b, {}).place(), this->Place);
    middle = this->Points.insert(this->Place, this->Cell.points()).Id;
    if (isOuter && this->Points.isShared())
    {
      this->HalvedEdges.edge(a.Point.Place, b.Point.Place).Middle = middle;
    }
    if (isOuter)
    {
      this->wakeNeighbors(cell, a.Faces & b.Faces);
    }
  }

  // If a cell with other points has halved the same edge.
  bool followOthers(const PieceCorner& a, const PieceCorner& b, vtkIdType& middle)
  {
    const vtkIdType halved = this->HalvedEdges.edge(a.Point.Place, b.Point.Place).Middle;
    if (halved < 0)
    {
      return false;
    }
    this->Cell.evaluate(middleOf(a, b, {}).place(), this->Place);
    const Vector3 apart = this->Points.position(halved) - this->Place.Position;
    const bool isSame = std::sqrt(dot(apart, apart)) <= SamePlace * this->Tolerance.Distance;
    if (isSame)
    {
      middle =
        this->Points.insertAt(static_cast<std::uint32_t>(halved), this->Place, this->Cell.points())
          .Id;
    }
    return isSame;
  }

  // The cells that have all these faces' common corners.
  void wakeNeighbors(const CutCell& cell, int faces)
  {
    this->Common.clear();
    for (std::size_t corner = 0; corner < cell.Corners.size(); ++corner)
    {
      if ((facesOf(*cell.Shape, static_cast<int>(corner)) & faces) == faces)
      {
        this->Common.push_back(cell.Corners[corner].Place);
      }
    }
    this->CellsOfCorners.forEach(this->Common,
      [&](std::uint32_t index)
      {
        CutCell& other = this->Cells[index];
        if (&other != &cell && !other.IsWaiting)
        {
          other.IsWaiting = true;
          this->Waiting.push_back(index);
        }
      });
  }

  // Returns whether an edge is to be halved that pieces may have which were left whole.
  bool halve(CutCell& cell)
  {
    bool again = false;
    this->Stack.swap(cell.Pieces);
    cell.Pieces.clear();
    while (!this->Stack.empty())
    {
      const Piece piece = this->Stack.back();
      this->Stack.pop_back();
      bool isToBeHalved = false;
      for (const auto& ends : PieceEdges)
      {
        isToBeHalved |= this->middle(cell, piece[ends[0]], piece[ends[1]]) != EdgeTable::Whole;
      }
      if (!isToBeHalved)
      {
        cell.Pieces.push_back(piece);
        continue;
      }
      const int* ends = PieceEdges[longestEdge(piece, *cell.Shape)];
      vtkIdType& middle = this->middle(cell, piece[ends[0]], piece[ends[1]]);
      if (middle == EdgeTable::Whole)
      {
        this->setMiddle(cell, piece[ends[0]], piece[ends[1]], middle);
        again = true;
      }
      const PieceCorner half = middleOf(piece[ends[0]], piece[ends[1]], this->Points.point(middle));
      for (int i = 0; i < 2; ++i)
      {
        this->Stack.push_back(piece);
        this->Stack.back()[ends[i]] = half;
      }
    }
    return again;
  }

  vtkUnstructuredGrid* Grid;
  const CurvedTolerance& Tolerance;
  CurvedCell Cell; // that is cut
  OutputPoints Points;
  OutputCells Output;
  EdgeTable OuterEdges;  // by points
  EdgeTable HalvedEdges; // by places
  std::vector<CutCell> Cells;
  CornerCells CellsOfCorners;
  std::deque<std::uint32_t> Waiting; // indices of cells
  bool MeasuresDepartures;
  EdgeDepartures Departures;
  EdgeDeparture Departure; // of the last edge
  CurvedPlace Place;
  std::vector<Piece> Stack;
  std::vector<std::uint32_t> Common; // places
  vtkNew<vtkIdList> Ids;
};

std::string errorOf(vtkUnstructuredGrid* grid, vtkIdType cell, int type)
{
  const vtkIdType points = grid->GetCells()->GetCellSize(cell);
  const int wanted = pointsOfCurvedCell(type);
  if (wanted == 0 || points == wanted)
  {
    return {};
  }
  return "The offsets of the cell array give cell " + std::to_string(cell) + ", a " +
         nameOfCellType(type) + ", " + std::to_string(points) + " points; it must have " +
         std::to_string(wanted) + ". Repair the grid's cell array.";
}

} // namespace

std::string tessellate(vtkUnstructuredGrid* grid, const CurvedTolerance& tolerance,
  const std::function<bool(double)>& progress, vtkUnstructuredGrid* output,
  CurvedDeparture* departure)
{
  output->Initialize();
  output->AllocateExact(grid->GetNumberOfCells(), 4 * grid->GetNumberOfCells());
  Tessellator tessellator(grid, tolerance, output, departure != nullptr);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int type = grid->GetCellType(cell);
    std::string error = errorOf(grid, cell, type);
    if (!error.empty())
    {
      return error;
    }
    if (const CurvedShape* shape = curvedShape(type))
    {
      tessellator.add(cell, *shape);
    }
    else if (cellKinds()[type].Cut != CellCut::LowDimensional &&
             cellKinds()[type].Cut != CellCut::Empty)
    {
      tessellator.pass(cell);
    }
  }
  if (tessellator.refine(progress))
  {
    tessellator.write();
    if (departure)
    {
      *departure = tessellator.departure();
    }
  }
  return {};
}

} // namespace tetmarch
