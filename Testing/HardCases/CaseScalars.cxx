// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CaseScalars.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkSetGet.h" // vtkTemplateMacro
#include "vtkTypeInt64Array.h"
#include "vtkTypeUInt64Array.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace tetmarch::testing
{
namespace
{
using Array = vtkSmartPointer<vtkDataArray>;

// A value between low and high, by thousandths of the width (or by ones, if it is smaller), without
// overflow and without doubles, which would round.
template <typename T>
void spread(vtkDataArray* from, T* to, T low, std::uint64_t width)
{
  double range[2];
  from->GetRange(range);
  const std::uint64_t parts = std::min<std::uint64_t>(width, 1000);
  for (vtkIdType i = 0; i < from->GetNumberOfTuples(); ++i)
  {
    const double share = (from->GetComponent(i, 0) - range[0]) / (range[1] - range[0]);
    const auto part = static_cast<std::uint64_t>(share * static_cast<double>(parts));
    const std::uint64_t above = width / parts * part + width % parts * part / parts;
    to[i] = static_cast<T>(static_cast<std::uint64_t>(low) + above);
  }
}

template <typename T>
void spreadOverType(vtkDataArray* from, T* to)
{
  if constexpr (std::is_integral<T>::value)
  {
    const T low = std::numeric_limits<T>::lowest();
    const T high = std::numeric_limits<T>::max();
    spread(from, to, low, static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low));
  }
}

Array emptyLike(vtkDataArray* values, int vtkType)
{
  auto result = Array::Take(vtkDataArray::CreateDataArray(vtkType));
  result->SetName(values->GetName());
  result->SetNumberOfTuples(values->GetNumberOfTuples());
  return result;
}

Array asDoubles(vtkDataArray* values, const ValueMap& map)
{
  Array result = emptyLike(values, VTK_DOUBLE);
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    result->SetComponent(i, 0, map(values->GetComponent(i, 0), i));
  }
  return result;
}

Grid shallowCopy(vtkUnstructuredGrid* grid)
{
  auto copy = Grid::New();
  copy->ShallowCopy(grid);
  return copy;
}
} // namespace

Array overWholeType(vtkDataArray* values, int vtkType)
{
  Array result = emptyLike(values, vtkType);
  if (vtkType == VTK_BIT)
  {
    double range[2];
    values->GetRange(range);
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      const bool isHigh = values->GetComponent(i, 0) > 0.5 * (range[0] + range[1]);
      result->SetComponent(i, 0, isHigh ? 1.0 : 0.0);
    }
    return result;
  }
  switch (vtkType)
  {
    vtkTemplateMacro(spreadOverType(values, static_cast<VTK_TT*>(result->GetVoidPointer(0))));
  }
  return result;
}

Array asSigned64(vtkDataArray* values, std::int64_t low, std::uint64_t width)
{
  auto result = vtkSmartPointer<vtkTypeInt64Array>::New();
  result->SetName(values->GetName());
  result->SetNumberOfTuples(values->GetNumberOfTuples());
  spread<vtkTypeInt64>(values, result->GetPointer(0), low, width);
  return result;
}

Array asUnsigned64(vtkDataArray* values, std::uint64_t low, std::uint64_t width)
{
  auto result = vtkSmartPointer<vtkTypeUInt64Array>::New();
  result->SetName(values->GetName());
  result->SetNumberOfTuples(values->GetNumberOfTuples());
  spread<vtkTypeUInt64>(values, result->GetPointer(0), low, width);
  return result;
}

Grid withPointArray(vtkUnstructuredGrid* grid, const ArrayMap& map)
{
  Grid result = shallowCopy(grid);
  result->GetPointData()->SetScalars(map(grid->GetPointData()->GetArray("f")));
  return result;
}

Grid withCellArray(vtkUnstructuredGrid* grid, const ArrayMap& map)
{
  Grid result = shallowCopy(grid);
  result->GetCellData()->SetScalars(map(grid->GetCellData()->GetArray("c")));
  return result;
}

Grid withPointValues(vtkUnstructuredGrid* grid, const ValueMap& map)
{
  return withPointArray(grid, [&map](vtkDataArray* values) { return asDoubles(values, map); });
}

Grid withCellValues(vtkUnstructuredGrid* grid, const ValueMap& map)
{
  return withCellArray(grid, [&map](vtkDataArray* values) { return asDoubles(values, map); });
}
} // namespace tetmarch::testing
