// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scalars.h"

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

// The first component of the tuples that are asked for, as doubles.
struct FirstComponents
{
  template <typename Array>
  void operator()(Array* array, const std::vector<Id>& tuples, std::vector<double>& values)
  {
    const vtkIdType limit = array->GetNumberOfTuples();
    const auto range = vtk::DataArrayTupleRange(array);
    vtkSMPTools::For(0, static_cast<vtkIdType>(tuples.size()),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          values[i] = tuples[i] < limit ? static_cast<double>(range[tuples[i]][0]) : NotThere;
        }
      });
  }
};

std::vector<double> firstComponents(vtkDataArray* array, const std::vector<Id>& tuples)
{
  std::vector<double> values(tuples.size(), NotThere);
  FirstComponents worker;
  if (!vtkArrayDispatch::Dispatch::Execute(array, worker, tuples, values))
  {
    worker(array, tuples, values);
  }
  return values;
}

ScalarRange finiteRange(const std::vector<double>& values)
{
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  for (double value : values)
  {
    if (std::isfinite(value))
    {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (low > high)
  {
    return {};
  }
  // Wider than double precision can tell: keep halves, which is what the difference of the ends
  // needs.
  const double limit = 0.25 * std::numeric_limits<double>::max();
  const auto clamped = [limit](double x) { return std::min(std::max(x, -limit), limit); };
  return { clamped(low), clamped(high) };
}

float normalised(double value, const ScalarRange& range)
{
  if (!std::isfinite(value))
  {
    return UndrawnScalar;
  }
  const double share = (value - range.Low) / range.width();
  return static_cast<float>(std::min(std::max(share, 0.0), 1.0));
}

// The mean of the points of a cell: the scalar of the vertex in its centre.
double meanOfCell(vtkUnstructuredGrid* grid, Id cell, vtkDataArray* array, vtkIdList* points)
{
  grid->GetCells()->GetCellAtId(cell, points);
  const auto count = static_cast<double>(points->GetNumberOfIds());
  double mean = 0;
  for (vtkIdType point : *points)
  {
    mean += point < array->GetNumberOfTuples() ? array->GetComponent(point, 0) / count : NotThere;
  }
  return mean;
}

} // namespace

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

ScalarRange setPointScalars(vtkUnstructuredGrid* grid, vtkDataArray* array, TetMesh& mesh)
{
  std::vector<double> values = firstComponents(array, mesh.VertexPoints);
  if (!mesh.CenterCells.empty())
  {
    vtkNew<vtkIdList> points;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      if (mesh.VertexPoints[i] >= mesh.NumberOfPoints)
      {
        values[i] = meanOfCell(
          grid, mesh.CenterCells[mesh.VertexPoints[i] - mesh.NumberOfPoints], array, points);
      }
    }
  }
  const ScalarRange range = finiteRange(values);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    mesh.Vertices[i].Scalar = normalised(values[i], range);
  }
  return range;
}

ScalarRange makeCellScalars(vtkDataArray* array, const TetMesh& mesh, std::vector<float>& scalars)
{
  const std::vector<double> values = firstComponents(array, mesh.TetCells);
  const ScalarRange range = finiteRange(values);
  scalars.resize(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    scalars[i] = normalised(values[i], range);
  }
  return range;
}

} // namespace tetmarch
