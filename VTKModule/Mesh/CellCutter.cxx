// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CellCutter.h"

#include "Input/GridVersions.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetmarch
{
namespace
{

// Six times the signed volume.
double volume(const std::array<double, 3>& a, const std::array<double, 3>& b,
  const std::array<double, 3>& c, const std::array<double, 3>& d)
{
  const std::array<double, 3> u{ { b[0] - a[0], b[1] - a[1], b[2] - a[2] } };
  const std::array<double, 3> v{ { c[0] - a[0], c[1] - a[1], c[2] - a[2] } };
  const std::array<double, 3> w{ { d[0] - a[0], d[1] - a[1], d[2] - a[2] } };
  return (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
         (u[0] * v[1] - u[1] * v[0]) * w[2];
}

} // namespace

CellCutter::CellCutter(vtkUnstructuredGrid* grid, const PointNumbers& numbers)
  : Grid(grid)
  , Numbers(numbers)
  , CellArray(grid->GetCells())
  , Points(grid->GetPoints())
  , NumberOfPoints(grid->GetNumberOfPoints())
  , HigherOrder(grid)
{
}

void CellCutter::cut(vtkIdType cell, int type)
{
  const CellCut cut = this->Kinds[type].Cut;
  if (cut == CellCut::Tetrahedron)
  {
    this->readPoints(cell);
    this->add(cell, { { this->point(0), this->point(1), this->point(2), this->point(3) } });
    return;
  }
  this->Result.Report.LowDimensionalCells += cut == CellCut::LowDimensional ? 1 : 0;
  this->Result.Report.UnsupportedCells += cut == CellCut::Unsupported ? 1 : 0;
  if (cut != CellCut::Pieces && cut != CellCut::Polyhedron && cut != CellCut::ByVTK)
  {
    return;
  }
  this->Result.HasCutCells = true;
  this->readPoints(cell);
  this->CenterOfCell = -1;
  if (cut == CellCut::Pieces)
  {
    this->cutPieces(cell, *cellPieces(type));
  }
  else if (cut == CellCut::Polyhedron)
  {
    this->cutPolyhedron(cell);
  }
  else if (!this->cutParts(cell, type))
  {
    this->cutByVTK(cell, type);
  }
}

void CellCutter::readPoints(vtkIdType cell)
{
  this->CellArray->GetCellAtId(cell, this->PointIds);
  for (vtkIdType i = 0; !this->Numbers.Firsts.empty() && i < this->PointIds->GetNumberOfIds(); ++i)
  {
    this->PointIds->SetId(i, this->numberOf(this->PointIds->GetId(i)));
  }
}

CellCutter::Point CellCutter::position(Id id) const
{
  if (id >= this->NumberOfPoints)
  {
    return this->Mean;
  }
  Point p;
  this->Points->GetPoint(id, p.data());
  return p;
}

void CellCutter::add(vtkIdType cell, const std::array<Id, 4>& tet)
{
  this->Result.Tets.push_back(tet);
  this->Result.Cells.push_back(static_cast<Id>(cell));
}

void CellCutter::cutPieces(vtkIdType cell, const std::vector<CellPiece>& pieces)
{
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

// VTK would cut each part into five tetrahedra, which don't meet those of the next one.
bool CellCutter::cutParts(vtkIdType cell, int type)
{
  if (!isHigherOrderHexahedron(type) && !isHigherOrderWedge(type))
  {
    return false;
  }
  const LinearParts& parts =
    this->partsOf(type, this->HigherOrder.degreesOf(cell, type, this->PointIds->GetNumberOfIds()));
  this->PointsOfCell->DeepCopy(this->PointIds);
  this->IsPart = true;
  for (const std::vector<int>& part : parts.Points)
  {
    this->PointIds->SetNumberOfIds(static_cast<vtkIdType>(part.size()));
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      this->PointIds->SetId(static_cast<vtkIdType>(i), this->PointsOfCell->GetId(part[i]));
    }
    this->cutPieces(cell, *cellPieces(parts.Type));
  }
  this->IsPart = false;
  return !parts.Points.empty();
}

const LinearParts& CellCutter::partsOf(int type, const CellDegrees& degrees)
{
  const auto added = this->Parts.try_emplace({ type, degrees });
  if (added.second)
  {
    added.first->second = linearParts(type, degrees);
  }
  return added.first->second;
}

void CellCutter::cutPolyhedron(vtkIdType cell)
{
  this->Grid->GetFaceStream(cell, this->FaceStream);
  this->Triangles.clear();
  vtkIdType at = 0;
  for (vtkIdType faces = this->FaceStream->GetId(at++); faces > 0; --faces)
  {
    this->Face.clear();
    for (vtkIdType corners = this->FaceStream->GetId(at++); corners > 0; --corners)
    {
      this->Face.push_back(this->numberOf(this->FaceStream->GetId(at++)));
    }
    this->fan();
  }
  this->coneFromBestPoint(cell);
}

// Without new points.
void CellCutter::cutByVTK(vtkIdType cell, int type)
{
  this->Grid->GetCell(cell, this->Cell);
  this->Cell->PointIds->DeepCopy(this->PointIds); // which order VTK's tetrahedra
  this->Cell->Triangulate(0, this->CutIds, this->CutPoints);
  const vtkIdType count = this->CutIds->GetNumberOfIds();
  this->Result.Report.UnsupportedCells += count < 4 ? 1 : 0;
  const bool local = type == VTK_CONVEX_POINT_SET && ConvexPointSetsCountLocally;
  for (vtkIdType i = 0; i + 3 < count; i += 4)
  {
    std::array<Id, 4> tet;
    for (int j = 0; j < 4; ++j)
    {
      const vtkIdType id = this->CutIds->GetId(i + j);
      tet[j] = local ? this->point(id) : static_cast<Id>(id);
    }
    this->add(cell, tet);
  }
}

void CellCutter::fan()
{
  const std::vector<Id>& face = this->Face;
  const std::size_t n = face.size();
  const std::size_t s =
    std::min_element(face.begin(), face.end(), [this](Id a, Id b) { return this->isLess(a, b); }) -
    face.begin();
  for (std::size_t i = 1; i + 1 < n; ++i)
  {
    this->Triangles.push_back({ { face[s], face[(s + i) % n], face[(s + i + 1) % n] } });
  }
}

void CellCutter::cone(vtkIdType cell, Id apex)
{
  for (const auto& t : this->Triangles)
  {
    if (t[0] != apex && t[1] != apex && t[2] != apex)
    {
      this->add(cell, { { t[0], t[1], t[2], apex } });
    }
  }
}

void CellCutter::coneFromBestPoint(vtkIdType cell)
{
  if (this->Triangles.empty())
  {
    return;
  }
  const auto less = [this](Id a, Id b) { return this->isLess(a, b); };
  Id least = this->Triangles.front()[0];
  for (const auto& t : this->Triangles)
  {
    least = std::min({ least, t[0], t[1], t[2] }, less);
  }
  this->cone(cell, this->bestPoint(cell, least));
}

// The least if it sees all faces. A centre has the mean scalar of the whole cell: a part has none.
Id CellCutter::bestPoint(vtkIdType cell, Id least)
{
  if (this->seesAllFaces(least))
  {
    return least;
  }
  for (vtkIdType i = 0; this->IsPart && i < this->PointIds->GetNumberOfIds(); ++i)
  {
    if (this->seesAllFaces(this->point(i)))
    {
      return this->point(i);
    }
  }
  return this->IsPart ? least : this->centerOf(cell);
}

bool CellCutter::seesAllFaces(Id apex)
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

void CellCutter::findMean()
{
  const vtkIdType count = this->PointIds->GetNumberOfIds();
  this->Mean = { { 0, 0, 0 } };
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Point p = this->position(this->point(i));
    for (int k = 0; k < 3; ++k)
    {
      this->Mean[k] += p[k] / static_cast<double>(count);
    }
  }
}

Id CellCutter::centerOf(vtkIdType cell)
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

} // namespace tetmarch
