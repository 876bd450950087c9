// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/MeshScalars.h"

#include "Mesh/CornerScalars.h"
#include "Mesh/TupleValues.h"

#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointSet.h"

#include <cmath>
#include <utility>

namespace tetmarch
{
namespace
{

// The mean of the values at the points of a cell: that of the vertex in its centre.
double meanOfCell(
  vtkPointSet* grid, Id cell, vtkDataArray* array, const TupleScalar& scalar, vtkIdList* points)
{
  const auto tuples = vtk::DataArrayTupleRange(array);
  grid->GetCellPoints(cell, points);
  const auto count = static_cast<double>(points->GetNumberOfIds());
  double mean = 0;
  for (vtkIdType point : *points)
  {
    mean += point < tuples.size() ? scalarOf(tuples[point], scalar) / count : NotThere;
  }
  return mean;
}

std::vector<double> vertexValues(
  vtkPointSet* grid, vtkDataArray* array, const TetMesh& mesh, const TupleScalar& scalar)
{
  std::vector<double> values = scalarsOf(array, mesh.VertexPoints, scalar);
  if (!mesh.CenterCells.empty())
  {
    vtkNew<vtkIdList> points;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      if (mesh.VertexPoints[i] >= mesh.NumberOfPoints)
      {
        values[i] = meanOfCell(grid, mesh.CenterCells[mesh.VertexPoints[i] - mesh.NumberOfPoints],
          array, scalar, points);
      }
    }
  }
  return values;
}

// Of the vertices or of the tetrahedra.
std::vector<double> drawnValues(
  vtkPointSet* grid, const DrawnScalars& drawn, const TetMesh& mesh, const TupleScalar& scalar)
{
  return drawn.OfCells ? scalarsOf(drawn.Array, mesh.TetCells, scalar)
                       : vertexValues(grid, drawn.Array, mesh, scalar);
}

// Also those of points that share a vertex with another point.
FiniteRange drawnRange(
  vtkPointSet* grid, const DrawnScalars& drawn, const TetMesh& mesh, const TupleScalar& scalar)
{
  FiniteRange range = rangeOf(drawnValues(grid, drawn, mesh, scalar));
  if (!drawn.OfCells)
  {
    range.add(rangeOf(scalarsOf(drawn.Array, pointsOfSolids(mesh), scalar)));
  }
  return range;
}

// Reads and stores one scalar after the other.
class ScalarStore
{
public:
  ScalarStore(vtkPointSet* grid, const DrawnScalars& drawn, TetMesh& mesh)
    : Grid(grid)
    , Drawn(drawn)
    , Mesh(mesh)
    , Points(pointsOfSolids(mesh))
  {
  }

  MeshScalars make()
  {
    if (!this->Drawn.Array)
    {
      this->takeRanges();
      return std::move(this->Made);
    }
    this->addFirst();
    for (std::size_t k = 0; k < this->Drawn.Extra.size(); ++k)
    {
      this->addExtra(k);
    }
    return std::move(this->Made);
  }

private:
  // Only other pieces have values.
  void takeRanges()
  {
    const std::vector<FiniteRange>& whole = this->Drawn.Whole;
    for (std::size_t k = 0; k < whole.size(); ++k)
    {
      (k == 0 ? this->Made.Range : this->Made.Extra.Ranges.emplace_back()) = whole[k].range();
    }
  }

  ScalarRange rangeFor(std::size_t k, const std::vector<double>& values) const
  {
    return k < this->Drawn.Whole.size() ? this->Drawn.Whole[k].range() : finiteRange(values);
  }

  std::vector<double> valuesOf(const TupleScalar& scalar) const
  {
    return drawnValues(this->Grid, this->Drawn, this->Mesh, scalar);
  }

  float& first(std::size_t i)
  {
    return this->Drawn.OfCells ? this->Made.OfCells[i] : this->Mesh.Vertices[i].Scalar;
  }

  void addFirst()
  {
    const std::vector<double> values = this->valuesOf(this->Drawn.First);
    const std::vector<double> repeated = this->repeatedValues(this->Drawn.First);
    this->Made.Range = this->rangeFor(0, repeated.empty() ? values : repeated);
    this->Made.OfCells.resize(this->Drawn.OfCells ? values.size() : 0);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      this->first(i) = storedScalar(values[i], this->Made.Range);
    }
    const std::vector<float> ofPoints = this->findJumps(repeated, this->Made.Range);
    if (this->Made.Jump && this->Drawn.Extra.empty() && !this->Mesh.PointsAreSeparate &&
        !this->Mesh.Curvilinear)
    {
      this->Made.OfCorners = cornerScalars(this->Grid, this->Mesh, ofPoints);
    }
  }

  // The values of all points, if some of them coincide.
  std::vector<double> repeatedValues(const TupleScalar& scalar) const
  {
    return this->Drawn.OfCells ? std::vector<double>()
                               : scalarsOf(this->Drawn.Array, this->Points, scalar);
  }

  // The scalars of all points, as they are stored.
  std::vector<float> findJumps(const std::vector<double>& repeated, const ScalarRange& range)
  {
    std::vector<float> ofPoints(repeated.empty() ? 0 : this->Mesh.FirstPoints.size());
    for (std::size_t i = 0; i < repeated.size(); ++i)
    {
      ofPoints[this->Points[i]] = storedScalar(repeated[i], range);
    }
    this->Made.Jump =
      this->Made.Jump || (!ofPoints.empty() &&
                           scalarsJump(this->Mesh, ofPoints, roundingOf(this->Drawn.Array, range)));
    return ofPoints;
  }

  void addExtra(std::size_t k)
  {
    const std::size_t count = this->Drawn.Extra.size();
    const std::vector<double> values = this->valuesOf({ false, this->Drawn.Extra[k] });
    const double unit = this->Drawn.ExtraUnit;
    const std::vector<double> repeated = this->repeatedValues({ false, this->Drawn.Extra[k] });
    const ScalarRange range = unit > 0
                                ? ScalarRange{ 0, unit }
                                : this->rangeFor(k + 1, repeated.empty() ? values : repeated);
    this->findJumps(repeated, range);
    ExtraScalars& extra = this->Made.Extra;
    extra.Ranges.push_back(range);
    extra.Values.resize(count * values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const bool finite = std::isfinite(values[i]);
      extra.Values[count * i + k] = finite ? storedScalar(values[i], range) : 0.0f;
      if (!finite)
      {
        this->first(i) = UndrawnScalar;
        this->Made.Range.AllFinite = false;
      }
    }
  }

  vtkPointSet* Grid;
  const DrawnScalars& Drawn;
  TetMesh& Mesh;
  std::vector<Id> Points; // if some coincide
  MeshScalars Made{};
};

} // namespace

MeshScalars readScalars(vtkPointSet* grid, const DrawnScalars& drawn, TetMesh& mesh)
{
  return ScalarStore(grid, drawn, mesh).make();
}

std::vector<FiniteRange> rangesOf(vtkPointSet* grid, const DrawnScalars& drawn, const TetMesh& mesh)
{
  std::vector<FiniteRange> found{ drawnRange(grid, drawn, mesh, drawn.First) };
  for (const int component : drawn.Extra)
  {
    const FiniteRange range = drawnRange(grid, drawn, mesh, { false, component });
    if (!range.isAllFinite())
    {
      found.front().addNotFinite();
    }
    found.push_back(
      drawn.ExtraUnit > 0 ? FiniteRange(0, drawn.ExtraUnit, range.isAllFinite()) : range);
  }
  return found;
}

} // namespace tetmarch
