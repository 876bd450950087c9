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
    parallelFor(0, static_cast<vtkIdType>(this->Tuples.size()),
      [&](vtkIdType first, vtkIdType last) { this->read(array, first, last); });
  }
};

} // namespace

std::vector<double> scalarsOf(
  vtkDataArray* array, const std::vector<Id>& tuples, const TupleScalar& scalar)
{
  std::vector<double> values(tuples.size(), NotThere);
  ScalarReader reader{ tuples, scalar, values };
  if (!vtkArrayDispatch::Dispatch::Execute(array, reader))
  {
    // An array that computes its values may not be thread-safe.
    reader.read(array, 0, static_cast<vtkIdType>(tuples.size()));
  }
  return values;
}

} // namespace tetmarch
