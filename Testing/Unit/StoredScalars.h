// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Arrays, and what is stored of them
 */
#ifndef tetmarch_testing_StoredScalars_h
#define tetmarch_testing_StoredScalars_h

#include "Mesh/MeshScalars.h"

#include "UnitMeshes.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

namespace tetmarch::testing
{
inline void setComponent(vtkDataArray* array, int component, const std::vector<double>& values)
{
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetComponent(static_cast<vtkIdType>(i), component, values[i]);
  }
}

inline vtkSmartPointer<vtkDataArray> arrayOf(
  int type, const std::vector<double>& values, int components = 1, int component = 0)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  array->Fill(77.0);
  setComponent(array, component, values);
  return array;
}

inline DrawnScalars pointScalars(vtkDataArray* array, const TupleScalar& scalar)
{
  return { array, false, ComponentMix::Single, scalar };
}

/// The stored scalar of every point of a single tetrahedron.
inline std::array<float, 4> storedOf(
  vtkDataArray* array, ScalarRange& range, const TupleScalar& scalar = {})
{
  const Grid grid = singleTet();
  TetMesh mesh = built(grid);
  range = readScalars(grid, pointScalars(array, scalar), mesh).Range;
  std::array<float, 4> stored{};
  for (std::size_t v = 0; v < 4; ++v)
  {
    stored[mesh.VertexPoints[v]] = mesh.Vertices[v].Scalar;
  }
  return stored;
}
} // namespace tetmarch::testing

#endif
