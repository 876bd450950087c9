// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Arrays, and what is stored of them as scalars of meshes and as values of lattices
 */
#ifndef tetmarch_testing_StoredScalars_h
#define tetmarch_testing_StoredScalars_h

#include "Mesh/MeshScalars.h"
#include "Structured/StoredValues.h"

#include "UnitMeshes.h"

#include "vtkAngularPeriodicDataArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkSmartPointer.h"

#include <array>
#include <gtest/gtest.h>
#include <utility>
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

/// Pairs of (3, 4), (15, 20), (9, 12) and (12, 16), each component in memory of its own.
template <typename Value>
vtkSmartPointer<vtkSOADataArrayTemplate<Value>> pairsApart()
{
  auto array = vtkSmartPointer<vtkSOADataArrayTemplate<Value>>::New();
  array->SetNumberOfComponents(2);
  array->SetNumberOfTuples(4);
  setComponent(array, 0, { 3, 15, 9, 12 });
  setComponent(array, 1, { 4, 20, 12, 16 });
  return array;
}

/// (3, 4, 12) times 1, 5, 3 and 4: an array that computes its values whenever someone asks, by a
/// quarter turn about z.
inline vtkSmartPointer<vtkDataArray> turnedVectors()
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(4);
  setComponent(vectors, 0, { 4, 20, 12, 16 });
  setComponent(vectors, 1, { -3, -15, -9, -12 });
  setComponent(vectors, 2, { 12, 60, 36, 48 });
  auto turned = vtkSmartPointer<vtkAngularPeriodicDataArray<double>>::New();
  turned->InitializeArray(vectors);
  turned->SetAxis(VTK_PERIODIC_ARRAY_AXIS_Z);
  turned->SetAngle(90.0);
  return turned;
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

/// Of a lattice: the first values that are drawn.
inline StoredValues storedOf(vtkDataArray* array, const TupleScalar& scalar = {})
{
  return std::move(storeValues({ array, false, ComponentMix::Single, scalar }).front());
}

inline ValueType expectedType(int type)
{
  const int bytes = vtkDataArray::GetDataTypeSize(type);
  return type == VTK_BIT || bytes == 1 ? ValueType::UInt8
         : bytes == 2                  ? ValueType::UInt16
                                       : ValueType::Float32;
}

/// Each value comes back from what is stored to a rounding of the widths, and the ends of the range
/// are 0 and 1.
inline void expectValues(
  const StoredValues& stored, const std::vector<double>& values, double rounding = 1.2e-7)
{
  ASSERT_EQ(stored.Count, values.size());
  EXPECT_EQ(stored.bytes(), values.size() * StoredValues::sizeOf(stored.Type));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double exact = (values[i] - stored.Range.Low) / stored.Range.width();
    EXPECT_NEAR(double(stored.scalar(i)), exact, rounding) << i;
    if (stored.Type == ValueType::Float32)
    {
      EXPECT_EQ(stored.scalar(i), static_cast<float>(exact)) << i;
    }
  }
}
} // namespace tetmarch::testing

#endif
