// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/TupleValues.h"

#include "Parallel/ParallelFor.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"

namespace tetmarch
{
namespace
{

// Scalars of the requested tuples, as doubles.
template <typename Tuples>
struct ScalarReader
{
  const Tuples& Numbers;
  const TupleScalar& Scalar;
  std::vector<double>& Values;

  template <typename Array>
  void read(Array* array, vtkIdType first, vtkIdType last)
  {
    const vtkIdType limit = array->GetNumberOfTuples();
    const auto range = vtk::DataArrayTupleRange(array);
    for (vtkIdType i = first; i < last; ++i)
    {
      const Id tuple = this->Numbers[i];
      this->Values[i] = tuple < limit ? scalarOf(range[tuple], this->Scalar) : NotThere;
    }
  }

  template <typename Array>
  void operator()(Array* array)
  {
    parallelFor(0, static_cast<vtkIdType>(this->Numbers.size()),
      [&](vtkIdType first, vtkIdType last) { this->read(array, first, last); });
  }
};

template <typename Tuples>
std::vector<double> readScalarsOf(
  vtkDataArray* array, const Tuples& tuples, const TupleScalar& scalar)
{
  std::vector<double> values(tuples.size(), NotThere);
  ScalarReader<Tuples> reader{ tuples, scalar, values };
  if (!vtkArrayDispatch::Dispatch::Execute(array, reader))
  {
    // An array that computes its values may not be thread-safe.
    reader.read(array, 0, static_cast<vtkIdType>(tuples.size()));
  }
  return values;
}

} // namespace

std::vector<double> scalarsOf(
  vtkDataArray* array, const std::vector<Id>& tuples, const TupleScalar& scalar)
{
  return readScalarsOf(array, tuples, scalar);
}

std::vector<double> scalarsOf(
  vtkDataArray* array, const MeshArray<CellsOfTets>& tuples, const TupleScalar& scalar)
{
  return readScalarsOf(array, tuples, scalar);
}

std::vector<double> scalarsOf(
  vtkDataArray* array, const MeshArray<PointsOfVertices>& tuples, const TupleScalar& scalar)
{
  return readScalarsOf(array, tuples, scalar);
}

} // namespace tetmarch
