// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Arrays of every type become 0..1 and a range.
#include "StoredScalars.h"

#include "vtkDataArray.h"
#include "vtkType.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr int Types[] = { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
  VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
  VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE };

TEST(Scalars, AllTypesAndFirstComponent)
{
  for (const int type : Types)
  {
    for (const int components : { 1, 3 })
    {
      ScalarRange range;
      const auto stored = storedOf(arrayOf(type, { 4, 20, 12, 16 }, components), range);
      EXPECT_EQ(range.Low, 4.0) << type;
      EXPECT_EQ(range.High, 20.0) << type;
      EXPECT_EQ(stored, (std::array<float, 4>{ { 0.0f, 1.0f, 0.5f, 0.75f } })) << type;
    }
  }
}

void expectStored(
  vtkDataArray* array, const TupleScalar& scalar, double low, double high, const char* what)
{
  ScalarRange range;
  const auto stored = storedOf(array, range, scalar);
  EXPECT_DOUBLE_EQ(range.Low, low) << what;
  EXPECT_DOUBLE_EQ(range.High, high) << what;
  EXPECT_EQ(stored, (std::array<float, 4>{ { 0.0f, 1.0f, 0.5f, 0.75f } })) << what;
}

TEST(Scalars, AnyComponentAndMagnitudesOfAllTypes)
{
  for (const int type : Types)
  {
    const auto array = arrayOf(type, { 4, 20, 12, 16 }, 4, 3);
    expectStored(array, { false, 3 }, 4.0, 20.0, array->GetClassName());
    setComponent(array, 0, { 1, 5, 3, 4 });
    setComponent(array, 1, { 2, 10, 6, 8 });
    setComponent(array, 2, { 2, 10, 6, 8 });
    expectStored(array, { true, 0 }, 5.0, 25.0, array->GetClassName());
  }
}

template <typename Value>
void expectSOA()
{
  const auto array = pairsApart<Value>();
  expectStored(array, {}, 3.0, 15.0, array->GetClassName());
  expectStored(array, { false, 1 }, 4.0, 20.0, array->GetClassName());
  expectStored(array, { true, 0 }, 5.0, 25.0, array->GetClassName());
}

TEST(Scalars, StructuresOfArrays)
{
  expectSOA<float>();
  expectSOA<double>();
  expectSOA<short>();
  expectSOA<unsigned long long>();
}

TEST(Scalars, ArraysThatComputeTheirValues)
{
  const auto turned = turnedVectors();
  expectStored(turned, {}, 3.0, 15.0, "x");
  expectStored(turned, { false, 1 }, 4.0, 20.0, "y");
  expectStored(turned, { true, 0 }, 13.0, 65.0, "magnitude");
}

TEST(Scalars, Bits)
{
  ScalarRange range;
  const std::array<float, 4> bits{ { 0.0f, 1.0f, 1.0f, 0.0f } };
  EXPECT_EQ(storedOf(arrayOf(VTK_BIT, { 0, 1, 1, 0 }), range), bits);
  EXPECT_EQ(range.High, 1.0);
  const auto pairs = arrayOf(VTK_BIT, { 0, 1, 1, 0 }, 2, 1);
  setComponent(pairs, 0, { 0, 1, 1, 0 });
  EXPECT_EQ(storedOf(pairs, range, { false, 1 }), bits);
  EXPECT_EQ(storedOf(pairs, range, { true, 0 }), bits);
  EXPECT_EQ(range.High, std::sqrt(2.0));
}

// The vertex in a cell's centre has the mean of the magnitudes, as any point between vertices has.
TEST(Scalars, MagnitudesInTheCentresOfCells)
{
  const Grid grid = quadraticHexLattice(1, 0.0);
  TetMesh mesh = built(grid);
  ASSERT_EQ(mesh.CenterCells.size(), 1u);
  const auto vectors = arrayOf(
    VTK_DOUBLE, std::vector<double>(static_cast<std::size_t>(grid->GetNumberOfPoints()), 0.0), 2);
  double mean = 0.0;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    vectors->SetTuple2(i, 3.0 * double(i % 5) - 6.0, 4.0 * double(i % 5) - 8.0);
    mean += std::abs(5.0 * double(i % 5) - 10.0) / double(grid->GetNumberOfPoints());
  }
  const ScalarRange range = readScalars(grid, pointScalars(vectors, { true, 0 }), mesh).Range;
  for (std::size_t v = 0; v < mesh.Vertices.size(); ++v)
  {
    if (mesh.VertexPoints[v] >= mesh.NumberOfPoints)
    {
      EXPECT_NEAR(range.Low + double(mesh.Vertices[v].Scalar) * range.width(), mean, 1e-6);
    }
  }
}

TEST(Scalars, WhatIsNotFiniteIsNotDrawn)
{
  const double nan = std::nan("");
  const double inf = std::numeric_limits<double>::infinity();
  ScalarRange range;
  EXPECT_EQ(storedOf(arrayOf(VTK_DOUBLE, { nan, 1, 3, -inf }), range),
    (std::array<float, 4>{ { UndrawnScalar, 0.0f, 1.0f, UndrawnScalar } }));
  EXPECT_EQ(range.Low, 1.0);
  EXPECT_EQ(range.High, 3.0);
  EXPECT_FALSE(range.AllFinite);
  for (const float stored : storedOf(arrayOf(VTK_FLOAT, { nan, inf, -inf, nan }), range))
  {
    EXPECT_EQ(stored, UndrawnScalar);
  }
  EXPECT_TRUE(std::isfinite(range.Low) && std::isfinite(range.High));
  EXPECT_FALSE(range.AllFinite);
  storedOf(arrayOf(VTK_FLOAT, { 1, 2, 3, 4 }), range);
  EXPECT_TRUE(range.AllFinite);
  storedOf(arrayOf(VTK_FLOAT, { 1, 2, 3, 4 }, 2), range, { true, 0 });
  EXPECT_TRUE(range.AllFinite);
  storedOf(arrayOf(VTK_FLOAT, { 1, inf, 3, 4 }, 2), range, { true, 0 });
  EXPECT_FALSE(range.AllFinite);
}

TEST(Scalars, ConstantArrays)
{
  for (const double value : { 0.0, -5.0, 1e300, 1e-300 })
  {
    ScalarRange range;
    const auto stored = storedOf(arrayOf(VTK_DOUBLE, { value, value, value, value }), range);
    EXPECT_EQ(range.Low, value);
    EXPECT_EQ(range.High, value);
    EXPECT_EQ(range.width(), 1.0);
    EXPECT_EQ(stored, (std::array<float, 4>{ { 0.0f, 0.0f, 0.0f, 0.0f } }));
  }
}

TEST(Scalars, HugeAndTinyRanges)
{
  const double most = std::numeric_limits<double>::max();
  for (const double size : { most, 1e300, 1e-300, std::numeric_limits<double>::denorm_min() })
  {
    ScalarRange range;
    const auto stored = storedOf(arrayOf(VTK_DOUBLE, { -size, size, 0.0, size }), range);
    EXPECT_TRUE(std::isfinite(range.width()) && range.width() > 0.0) << size;
    EXPECT_EQ(stored, (std::array<float, 4>{ { 0.0f, 1.0f, 0.5f, 1.0f } })) << size;
  }
}

TEST(Scalars, OneACellGoesToAllItsTetrahedra)
{
  const Grid grid = hexLattice(2);
  TetMesh mesh = built(grid);
  const auto array = arrayOf(VTK_INT, { 0, 1, 2, 3, 4, 5, 6, 7 });
  const MeshScalars read = readScalars(grid, { array, true }, mesh);
  const std::vector<float>& scalars = read.OfCells;
  EXPECT_EQ(read.Range.High, 7.0);
  ASSERT_EQ(scalars.size(), mesh.Tets.size());
  for (std::size_t t = 0; t < scalars.size(); ++t)
  {
    EXPECT_FLOAT_EQ(scalars[t] * 7.0f, static_cast<float>(mesh.TetCells[t]));
  }
}

TEST(Scalars, HugeValuesOfOneSign)
{
  const double most = std::numeric_limits<double>::max();
  for (const double sign : { 1.0, -1.0 })
  {
    ScalarRange range;
    storedOf(
      arrayOf(VTK_DOUBLE, { sign * most, sign * 0.9 * most, sign * most, sign * most }), range);
    EXPECT_LE(range.Low, range.High) << sign;
    EXPECT_TRUE(std::isfinite(range.Low) && std::isfinite(range.High)) << sign;
  }
}

TEST(Scalars, ArraysThatDontFitAreToldByName)
{
  const auto array = arrayOf(VTK_FLOAT, { 1, 2, 3 });
  array->SetName("pressure");
  const Grid grid = singleTet(); // 4 points, 1 cell
  for (const bool ofCells : { false, true })
  {
    const std::string error = checkScalars(grid, array, ofCells);
    for (const char* word : { "\"pressure\"", "3 tuples", ofCells ? "1 cells" : "4 points" })
    {
      EXPECT_NE(error.find(word), std::string::npos) << word << " in: " << error;
    }
  }
  array->SetNumberOfTuples(4);
  EXPECT_EQ(checkScalars(grid, array, false), "");
  array->SetNumberOfTuples(1);
  EXPECT_EQ(checkScalars(grid, array, true), "");
}

// Without a check before: values that aren't there aren't drawn.
TEST(Scalars, TuplesThatAreNotThereAreNotDrawn)
{
  ScalarRange range;
  EXPECT_EQ(storedOf(arrayOf(VTK_DOUBLE, { 1, 3 }), range),
    (std::array<float, 4>{ { 0.0f, 1.0f, UndrawnScalar, UndrawnScalar } }));
  const Grid grid = quadraticHexLattice(2, 0.1);
  TetMesh mesh = built(grid);
  ASSERT_FALSE(mesh.CenterCells.empty());
  readScalars(grid, { arrayOf(VTK_DOUBLE, { 1, 3 }) }, mesh);
  for (std::size_t v = 0; v < mesh.Vertices.size(); ++v)
  {
    EXPECT_EQ(mesh.Vertices[v].Scalar == UndrawnScalar, mesh.VertexPoints[v] >= 2) << v;
  }
  const std::vector<float> scalars =
    readScalars(grid, { arrayOf(VTK_INT, { 5 }), true }, mesh).OfCells;
  for (std::size_t t = 0; t < scalars.size(); ++t)
  {
    EXPECT_EQ(scalars[t] == UndrawnScalar, mesh.TetCells[t] != 0) << t;
  }
}

// Values of points that no tetrahedron uses don't widen the range.
TEST(Scalars, UnusedPointsDontCount)
{
  const Grid grid = singleTet();
  grid->GetPoints()->InsertNextPoint(9.0, 9.0, 9.0);
  TetMesh mesh = built(grid);
  const ScalarRange range =
    readScalars(grid, { arrayOf(VTK_DOUBLE, { 1, 2, 3, 4, 1e9 }) }, mesh).Range;
  EXPECT_EQ(range.High, 4.0);
}
} // namespace
