// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Decomposition.h"

#include "CellShapes.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetmarch
{
namespace
{

using Point = std::array<double, 3>;

// Six times the signed volume.
double volume(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const Point u{ { b[0] - a[0], b[1] - a[1], b[2] - a[2] } };
  const Point v{ { c[0] - a[0], c[1] - a[1], c[2] - a[2] } };
  const Point w{ { d[0] - a[0], d[1] - a[1], d[2] - a[2] } };
  return (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
         (u[0] * v[1] - u[1] * v[0]) * w[2];
}

// Cuts the cells of one range; ranges are cut in parallel and joined in order.
class CellCutter
{
public:
  explicit CellCutter(vtkUnstructuredGrid* grid)
    : Grid(grid)
    , Types(grid->GetCellTypesArray())
    , CellArray(grid->GetCells())
    , NumberOfPoints(grid->GetNumberOfPoints())
  {
  }

  Decomposition Result;
  std::string Error;

  void cut(vtkIdType first, vtkIdType last)
  {
    for (vtkIdType cell = first; cell < last && this->Error.empty(); ++cell)
    {
      this->cutCell(cell, this->Types->GetValue(cell));
    }
  }

private:
  void cutCell(vtkIdType cell, int type)
  {
    if (type == VTK_EMPTY_CELL)
    {
      return;
    }
    if (type < VTK_TETRA)
    {
      ++this->Result.Report.LowDimensionalCells;
      return;
    }
    this->CellArray->GetCellAtId(cell, this->PointIds);
    if (!this->hasValidIds(cell))
    {
      return;
    }
    if (type == VTK_TETRA)
    {
      if (this->hasEnoughPoints(cell, type, 4))
      {
        this->add(cell, { { this->point(0), this->point(1), this->point(2), this->point(3) } });
      }
    }
    else
    {
      this->Result.HasCutCells = true;
      this->cutOther(cell, type);
    }
  }

  void cutOther(vtkIdType cell, int type)
  {
    if (type == VTK_POLYHEDRON)
    {
      this->cutPolyhedron(cell);
    }
    else if (const std::vector<CellPiece>* pieces = cellPieces(type))
    {
      this->cutPieces(cell, type, *pieces);
    }
    else
    {
      this->cutByVTK(cell, type);
    }
  }

  Id point(int i) const { return static_cast<Id>(this->PointIds->GetId(i)); }

  Point position(Id id) const
  {
    if (id >= this->NumberOfPoints)
    {
      return this->Mean;
    }
    Point p;
    this->Grid->GetPoints()->GetPoint(id, p.data());
    return p;
  }

  bool hasValidIds(vtkIdType cell)
  {
    for (vtkIdType i = 0; i < this->PointIds->GetNumberOfIds(); ++i)
    {
      const vtkIdType id = this->PointIds->GetId(i);
      if (id < 0 || id >= this->NumberOfPoints)
      {
        this->Error = "The connectivity of cell " + std::to_string(cell) + " names point " +
                      std::to_string(id) + ", but the grid has " +
                      std::to_string(this->NumberOfPoints) +
                      " points. Repair the grid's cell array.";
        return false;
      }
    }
    return true;
  }

  bool hasEnoughPoints(vtkIdType cell, int type, vtkIdType count)
  {
    const vtkIdType found = this->PointIds->GetNumberOfIds();
    if (found == count)
    {
      return true;
    }
    this->Error = "Cell " + std::to_string(cell) + " of type " +
                  vtkCellTypes::GetClassNameFromTypeId(type) + " has " + std::to_string(found) +
                  " points instead of " + std::to_string(count) + ". Repair the grid's cell array.";
    return false;
  }

  void add(vtkIdType cell, const std::array<Id, 4>& tet)
  {
    this->Result.Tets.push_back(tet);
    this->Result.Cells.push_back(static_cast<Id>(cell));
  }

  void cutPieces(vtkIdType cell, int type, const std::vector<CellPiece>& pieces)
  {
    int count = 0;
    for (const CellPiece& piece : pieces)
    {
      count = std::max(count, piece.Apex + 1);
      for (const Polygon& face : piece.Faces)
      {
        count = std::max(count, *std::max_element(face.begin(), face.end()) + 1);
      }
    }
    if (!this->hasEnoughPoints(cell, type, count))
    {
      return;
    }
    this->CenterOfCell = -1;
    for (const CellPiece& piece : pieces)
    {
      this->Triangles.clear();
      for (const Polygon& face : piece.Faces)
      {
        this->Face.clear();
        for (int corner : face)
        {
          this->Face.push_back(this->point(corner));
        }
        this->fan();
      }
      if (piece.Apex >= 0)
      {
        this->cone(cell, this->point(piece.Apex));
      }
      else if (piece.Apex == ApexMean)
      {
        this->cone(cell, this->centerOf(cell));
      }
      else
      {
        this->coneFromBestPoint(cell);
      }
    }
  }

  void cutPolyhedron(vtkIdType cell)
  {
    this->Grid->GetFaceStream(cell, this->FaceStream);
    const vtkIdType size = this->FaceStream->GetNumberOfIds();
    this->CenterOfCell = -1;
    this->Triangles.clear();
    const vtkIdType faces = size > 0 ? this->FaceStream->GetId(0) : 0;
    vtkIdType at = 1;
    for (vtkIdType f = 0; f < faces && at < size; ++f)
    {
      const vtkIdType corners = this->FaceStream->GetId(at++);
      this->Face.clear();
      for (vtkIdType i = 0; i < corners && at < size; ++i)
      {
        const vtkIdType id = this->FaceStream->GetId(at++);
        if (id < 0 || id >= this->NumberOfPoints)
        {
          this->Error = "The faces of polyhedron " + std::to_string(cell) + " name point " +
                        std::to_string(id) + ", but the grid has " +
                        std::to_string(this->NumberOfPoints) +
                        " points. Repair the grid's face arrays.";
          return;
        }
        this->Face.push_back(static_cast<Id>(id));
      }
      this->fan();
    }
    if (!this->Triangles.empty())
    {
      this->coneFromBestPoint(cell);
    }
  }

  // Types without a table of faces: as VTK cuts them, without new points.
  void cutByVTK(vtkIdType cell, int type)
  {
    this->Grid->GetCell(cell, this->Cell);
    if (this->Cell->GetCellDimension() < 3)
    {
      ++this->Result.Report.LowDimensionalCells;
      return;
    }
    vtkNew<vtkIdList> ids;
    vtkNew<vtkPoints> points;
    if (type == VTK_HIGHER_ORDER_TETRAHEDRON || !this->Cell->Triangulate(0, ids, points) ||
        ids->GetNumberOfIds() % 4 != 0 || ids->GetNumberOfIds() == 0)
    {
      ++this->Result.Report.UnsupportedCells;
      return;
    }
    for (vtkIdType i = 0; i + 3 < ids->GetNumberOfIds(); i += 4)
    {
      std::array<Id, 4> tet;
      for (int j = 0; j < 4; ++j)
      {
        tet[j] = static_cast<Id>(ids->GetId(i + j));
      }
      this->add(cell, tet);
    }
  }

  // The face as triangles through its corner with the smallest id.
  void fan()
  {
    const std::vector<Id>& face = this->Face;
    const std::size_t n = face.size();
    if (n < 3)
    {
      return;
    }
    const std::size_t s = std::min_element(face.begin(), face.end()) - face.begin();
    for (std::size_t i = 1; i + 1 < n; ++i)
    {
      this->Triangles.push_back({ { face[s], face[(s + i) % n], face[(s + i + 1) % n] } });
    }
  }

  void cone(vtkIdType cell, Id apex)
  {
    for (const auto& t : this->Triangles)
    {
      if (t[0] != apex && t[1] != apex && t[2] != apex)
      {
        this->add(cell, { { t[0], t[1], t[2], apex } });
      }
    }
  }

  void coneFromBestPoint(vtkIdType cell)
  {
    Id smallest = std::numeric_limits<Id>::max();
    for (const auto& t : this->Triangles)
    {
      smallest = std::min({ smallest, t[0], t[1], t[2] });
    }
    this->cone(cell, this->seesAllFaces(smallest) ? smallest : this->centerOf(cell));
  }

  // Whether the point lies on the inner side of every triangle, as the mean of the cell's points
  // does.
  bool seesAllFaces(Id apex)
  {
    this->findMean();
    const Point a = this->position(apex);
    double most = 0;
    double least = 0;
    for (const auto& t : this->Triangles)
    {
      const Point p = this->position(t[0]), q = this->position(t[1]), r = this->position(t[2]);
      const double inner = volume(p, q, r, this->Mean);
      const double seen = inner < 0 ? -volume(p, q, r, a) : volume(p, q, r, a);
      most = std::max(most, std::abs(inner));
      least = std::min(least, seen);
    }
    return least >= -1e-9 * most; // rounding, where faces are coplanar with the point
  }

  void findMean()
  {
    const vtkIdType count = this->PointIds->GetNumberOfIds();
    this->Mean = { { 0, 0, 0 } };
    for (vtkIdType i = 0; i < count; ++i)
    {
      const Point p = this->position(this->point(static_cast<int>(i)));
      for (int k = 0; k < 3; ++k)
      {
        this->Mean[k] += p[k] / static_cast<double>(count);
      }
    }
  }

  // Number of the cell's centre, local to this cutter until the ranges are joined.
  Id centerOf(vtkIdType cell)
  {
    if (this->CenterOfCell < 0)
    {
      this->findMean();
      this->CenterOfCell = static_cast<vtkIdType>(this->Result.CenterCells.size());
      this->Result.CenterCells.push_back(static_cast<Id>(cell));
      this->Result.CenterPositions.push_back(this->Mean);
    }
    return static_cast<Id>(this->NumberOfPoints + this->CenterOfCell);
  }

  vtkUnstructuredGrid* Grid;
  vtkUnsignedCharArray* Types;
  vtkCellArray* CellArray;
  vtkIdType NumberOfPoints;
  vtkNew<vtkIdList> PointIds;
  vtkNew<vtkIdList> FaceStream;
  vtkNew<vtkGenericCell> Cell;
  std::vector<Id> Face;
  std::vector<std::array<Id, 3>> Triangles;
  Point Mean{ { 0, 0, 0 } };
  vtkIdType CenterOfCell = -1;
};

template <typename T>
void append(std::vector<T>& to, const std::vector<T>& from)
{
  to.insert(to.end(), from.begin(), from.end());
}

// Join the result of one range to those before it.
void join(Decomposition& result, Decomposition&& part, Id numberOfPoints)
{
  const Id centersBefore = static_cast<Id>(result.CenterCells.size());
  if (centersBefore > 0 && !part.CenterCells.empty())
  {
    for (auto& tet : part.Tets)
    {
      for (Id& id : tet)
      {
        id += id >= numberOfPoints ? centersBefore : 0;
      }
    }
  }
  append(result.Tets, part.Tets);
  append(result.Cells, part.Cells);
  append(result.CenterCells, part.CenterCells);
  append(result.CenterPositions, part.CenterPositions);
  result.HasCutCells = result.HasCutCells || part.HasCutCells;
  result.Report.LowDimensionalCells += part.Report.LowDimensionalCells;
  result.Report.UnsupportedCells += part.Report.UnsupportedCells;
  part = {};
}

std::string checkSizes(vtkUnstructuredGrid* grid)
{
  const vtkIdType cells = grid->GetNumberOfCells();
  if (cells == 0)
  {
    return {};
  }
  if (!grid->GetPoints() || !grid->GetCells() || !grid->GetCellTypesArray())
  {
    return "The grid has " + std::to_string(cells) +
           " cells but no points, no cell array or no cell types. Set them before rendering.";
  }
  if (grid->GetCellTypesArray()->GetNumberOfTuples() != cells)
  {
    return "The grid has " + std::to_string(cells) + " cells but " +
           std::to_string(grid->GetCellTypesArray()->GetNumberOfTuples()) + " cell types.";
  }
  // Ids are 32 bits wide, one bit is the mark of the outside, and centres of cells come behind the
  // points.
  const vtkIdType limit = vtkIdType(1) << 31;
  if (cells >= limit || grid->GetNumberOfPoints() >= limit)
  {
    return "The grid has " + std::to_string(cells) + " cells and " +
           std::to_string(grid->GetNumberOfPoints()) + " points; at most " + std::to_string(limit) +
           " of each can be rendered. Extract a part of it.";
  }
  return {};
}

} // namespace

std::string decompose(
  vtkUnstructuredGrid* grid, const Progress& progress, Decomposition& result, bool& stopped)
{
  stopped = false;
  result = {};
  std::string sizes = checkSizes(grid);
  const vtkIdType cells = grid->GetNumberOfCells();
  if (!sizes.empty() || cells == 0)
  {
    return sizes;
  }
  // GetCell() builds caches on first use: do it before the threads.
  grid->GetCellType(0);
  vtkNew<vtkGenericCell> cell;
  grid->GetCell(0, cell);

  const vtkIdType ranges = std::min<vtkIdType>(64, cells / 1024 + 1);
  const vtkIdType portion = 8; // ranges between two reports of progress
  result.Tets.reserve(cells);
  result.Cells.reserve(cells);
  for (vtkIdType begin = 0; begin < ranges; begin += portion)
  {
    const vtkIdType end = std::min(begin + portion, ranges);
    std::vector<Decomposition> parts(end - begin);
    std::vector<std::string> errors(end - begin);
    vtkSMPTools::For(begin, end, 1,
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType range = first; range < last; ++range)
        {
          CellCutter cutter(grid);
          const vtkIdType from = range * cells / ranges;
          const vtkIdType to = (range + 1) * cells / ranges;
          cutter.Result.Tets.reserve(to - from);
          cutter.Result.Cells.reserve(to - from);
          cutter.cut(from, to);
          parts[range - begin] = std::move(cutter.Result);
          errors[range - begin] = cutter.Error;
        }
      });
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      if (!errors[i].empty())
      {
        return errors[i];
      }
      join(result, std::move(parts[i]), static_cast<Id>(grid->GetNumberOfPoints()));
    }
    if (progress && !progress(static_cast<double>(end) / static_cast<double>(ranges)))
    {
      stopped = true;
      return {};
    }
  }
  return {};
}

} // namespace tetmarch
