// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Scalars.h"

#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetmarch
{
namespace
{

constexpr double NotThere = std::numeric_limits<double>::quiet_NaN();

// Scalars of the tuples that are asked for, as doubles.
struct ScalarReader
{
  const std::vector<Id>& Tuples;
  const TupleScalar& Scalar;
  std::vector<double>& Values;

  template <typename Array>
  void read(Array* array, vtkIdType first, vtkIdType last)
  {
    const vtkIdType limit = array->GetNumberOfTuples();
    const auto range = vtk::DataArrayTupleRange(array);
    for (vtkIdType i = first; i < last; ++i)
    {
      const Id tuple = this->Tuples[i];
      this->Values[i] = tuple < limit ? scalarOf(range[tuple], this->Scalar) : NotThere;
    }
  }

  template <typename Array>
  void operator()(Array* array)
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->Tuples.size()),
      [&](vtkIdType first, vtkIdType last) { this->read(array, first, last); });
  }
};

std::vector<double> scalarsOf(
  vtkDataArray* array, const std::vector<Id>& tuples, const TupleScalar& scalar)
{
  std::vector<double> values(tuples.size(), NotThere);
  ScalarReader reader{ tuples, scalar, values };
  if (!vtkArrayDispatch::Dispatch::Execute(array, reader))
  {
    // One that computes its values may keep the last one: a single thread asks it.
    reader.read(array, 0, static_cast<vtkIdType>(tuples.size()));
  }
  return values;
}

// The mean of the points of a cell: the scalar of the vertex in its centre.
double meanOfCell(vtkUnstructuredGrid* grid, Id cell, vtkDataArray* array,
  const TupleScalar& scalar, vtkIdList* points)
{
  const auto tuples = vtk::DataArrayTupleRange(array);
  grid->GetCells()->GetCellAtId(cell, points);
  const auto count = static_cast<double>(points->GetNumberOfIds());
  double mean = 0;
  for (vtkIdType point : *points)
  {
    mean += point < tuples.size() ? scalarOf(tuples[point], scalar) / count : NotThere;
  }
  return mean;
}

} // namespace

ScalarRange finiteRange(const std::vector<double>& values)
{
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  bool allFinite = true;
  for (double value : values)
  {
    if (std::isfinite(value))
    {
      low = std::min(low, value);
      high = std::max(high, value);
    }
    else
    {
      allFinite = false;
    }
  }
  if (low > high)
  {
    return { 0, 0, allFinite };
  }
  // Wider than double precision can tell: keep halves, which is what the difference of the ends
  // needs.
  const double limit = 0.25 * std::numeric_limits<double>::max();
  const auto clamped = [limit](double x) { return std::min(std::max(x, -limit), limit); };
  return { clamped(low), clamped(high), allFinite };
}

float storedScalar(double value, const ScalarRange& range)
{
  if (!std::isfinite(value))
  {
    return UndrawnScalar;
  }
  const double share = (value - range.Low) / range.width();
  return static_cast<float>(std::min(std::max(share, 0.0), 1.0));
}

std::string checkScalars(vtkDataArray* array, vtkIdType count, const char* what)
{
  if (array->GetNumberOfTuples() == count)
  {
    return {};
  }
  return std::string("The scalar array \"") + (array->GetName() ? array->GetName() : "") +
         "\" has " + std::to_string(array->GetNumberOfTuples()) + " tuples, but the grid has " +
         std::to_string(count) + " " + what + ".";
}

std::vector<double> pointValues(
  vtkUnstructuredGrid* grid, vtkDataArray* array, const TetMesh& mesh, const TupleScalar& scalar)
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

std::vector<double> cellValues(vtkDataArray* array, const TetMesh& mesh, const TupleScalar& scalar)
{
  return scalarsOf(array, mesh.TetCells, scalar);
}

ScalarRange setPointScalars(
  vtkUnstructuredGrid* grid, vtkDataArray* array, TetMesh& mesh, const TupleScalar& scalar)
{
  const std::vector<double> values = pointValues(grid, array, mesh, scalar);
  const ScalarRange range = finiteRange(values);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    mesh.Vertices[i].Scalar = storedScalar(values[i], range);
  }
  return range;
}

ScalarRange makeCellScalars(
  vtkDataArray* array, const TetMesh& mesh, std::vector<float>& scalars, const TupleScalar& scalar)
{
  const std::vector<double> values = cellValues(array, mesh, scalar);
  const ScalarRange range = finiteRange(values);
  scalars.resize(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    scalars[i] = storedScalar(values[i], range);
  }
  return range;
}

} // namespace tetmarch
