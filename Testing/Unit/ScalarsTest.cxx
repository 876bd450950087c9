// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Arrays of every type become 0..1 and a range: scalars of meshes, and values of lattices.
#include "StoredScalars.h"

#include "vtkDataArray.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Inf = std::numeric_limits<double>::infinity();
constexpr int Types[] = { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
  VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
  VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE };

// An array of four tuples, and what meshes and lattices store of it.
struct Case
{
  std::string Name;
  vtkSmartPointer<vtkDataArray> Array;
  TupleScalar Scalar;
  double Low = 0;
  double High = 0;
  std::array<float, 4> Stored{ { 0.0f, 1.0f, 0.5f, 0.75f } };
  bool AllFinite = true;
};
using Cases = std::vector<Case>;

// Any component, and magnitudes, of all types.
void addTypes(Cases& cases)
{
  for (const int type : Types)
  {
    const std::string name = vtkImageScalarTypeNameMacro(type);
    for (const int components : { 1, 3 })
    {
      cases.push_back({ name, arrayOf(type, { 4, 20, 12, 16 }, components), {}, 4, 20 });
    }
    const auto array = arrayOf(type, { 4, 20, 12, 16 }, 4, 3);
    setComponent(array, 0, { 1, 5, 3, 4 });
    setComponent(array, 1, { 2, 10, 6, 8 });
    setComponent(array, 2, { 2, 10, 6, 8 });
    cases.push_back({ name + ", the last of four", array, { false, 3 }, 4, 20 });
    cases.push_back({ name + ", magnitude", array, { true, 0 }, 5, 25 });
  }
}

// Each component in memory of its own.
template <typename Value>
void addSOA(Cases& cases)
{
  const auto array = pairsApart<Value>();
  const std::string name = array->GetClassName();
  cases.push_back({ name, array, {}, 3, 15 });
  cases.push_back({ name + ", second", array, { false, 1 }, 4, 20 });
  cases.push_back({ name + ", magnitude", array, { true, 0 }, 5, 25 });
  auto single = vtkSmartPointer<vtkSOADataArrayTemplate<Value>>::New();
  single->SetNumberOfComponents(1);
  single->SetNumberOfTuples(4);
  setComponent(single, 0, { 4, 20, 12, 16 });
  cases.push_back({ name + ", alone", single, {}, 4, 20 });
}

void addStorage(Cases& cases)
{
  addSOA<unsigned char>(cases);
  addSOA<unsigned short>(cases);
  addSOA<short>(cases);
  addSOA<float>(cases);
  addSOA<double>(cases);
  addSOA<unsigned long long>(cases);
  const auto turned = turnedVectors(); // computes its values
  cases.push_back({ "turned, x", turned, {}, 3, 15 });
  cases.push_back({ "turned, y", turned, { false, 1 }, 4, 20 });
  cases.push_back({ "turned, magnitude", turned, { true, 0 }, 13, 65 });
  const std::array<float, 4> bits{ { 0.0f, 1.0f, 1.0f, 0.0f } };
  cases.push_back({ "bits", arrayOf(VTK_BIT, { 0, 1, 1, 0 }), {}, 0, 1, bits });
  const auto pairs = arrayOf(VTK_BIT, { 0, 1, 1, 0 }, 2, 1);
  setComponent(pairs, 0, { 0, 1, 1, 0 });
  cases.push_back({ "pairs of bits", pairs, { false, 1 }, 0, 1, bits });
  cases.push_back({ "magnitude of bits", pairs, { true, 0 }, 0, std::sqrt(2.0), bits });
}

// Values that are not finite are not drawn. A constant array is stored as 0.
void addValues(Cases& cases)
{
  constexpr float None = UndrawnScalar;
  const auto add = [&cases](const char* name, int type, const std::vector<double>& values,
                     const std::array<double, 2>& range, const std::array<float, 4>& stored) {
    cases.push_back({ name, arrayOf(type, values), {}, range[0], range[1], stored });
  };
  for (const double value : { 0.0, -5.0, 1e300, 1e-300 })
  {
    add("constant", VTK_DOUBLE, { value, value, value, value }, { value, value }, {});
  }
  for (const int type : Types)
  {
    add("constant", type, { 1, 1, 1, 1 }, { 1, 1 }, {});
  }
  add("constant", VTK_UNSIGNED_CHAR, { 200, 200, 200, 200 }, { 200, 200 }, {});
  for (const double size : { 1e300, 1e-300, std::numeric_limits<double>::denorm_min() })
  {
    add("huge or tiny", VTK_DOUBLE, { -size, size, 0.0, size }, { -size, size }, { 0, 1, 0.5f, 1 });
  }
  const std::size_t finite = cases.size();
  add("NaN and infinity", VTK_DOUBLE, { NaN, 1, 3, -Inf }, { 1, 3 }, { None, 0, 1, None });
  add("nothing finite", VTK_FLOAT, { NaN, Inf, -Inf, NaN }, {}, { None, None, None, None });
  const auto pairs = arrayOf(VTK_FLOAT, { 4, Inf, 20, 12 }, 2);
  setComponent(pairs, 1, { 0, 0, 0, 0 });
  cases.push_back({ "infinite magnitude", pairs, { true, 0 }, 4, 20, { 0, None, 1, 0.5f } });
  std::for_each(cases.begin() + finite, cases.end(), [](Case& of) { of.AllFinite = false; });
}

Cases allCases()
{
  Cases cases;
  addTypes(cases);
  addStorage(cases);
  addValues(cases);
  return cases;
}

void expectRange(const ScalarRange& range, const Case& of)
{
  EXPECT_DOUBLE_EQ(range.Low, of.Low);
  EXPECT_DOUBLE_EQ(range.High, of.High);
  EXPECT_EQ(range.AllFinite, of.AllFinite);
  EXPECT_TRUE(std::isfinite(range.width()) && range.width() > 0.0);
}

TEST(Scalars, OfArraysAtVertices)
{
  for (const Case& of : allCases())
  {
    SCOPED_TRACE(of.Name);
    ScalarRange range;
    EXPECT_EQ(storedOf(of.Array, range, of.Scalar), of.Stored);
    expectRange(range, of);
  }
}

// Bytes and words are read from 8 and 16 bits, to a rounding.
TEST(Scalars, OfArraysInLattices)
{
  for (const Case& of : allCases())
  {
    SCOPED_TRACE(of.Name);
    const StoredValues stored = storedOf(of.Array, of.Scalar);
    EXPECT_EQ(stored.Type,
      of.Scalar.Magnitude ? ValueType::Float32 : expectedType(of.Array->GetDataType()));
    ASSERT_EQ(stored.Count, 4u);
    const double rounding = stored.Type == ValueType::Float32 ? 0.0
                            : stored.Borrowed                 ? 7e-7
                                                              : 1.2e-7;
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(stored.scalar(i), of.Stored[i], rounding) << i;
    }
    expectRange(stored.Range, of);
  }
}

TEST(Scalars, HugeValuesAreFinite)
{
  const double most = std::numeric_limits<double>::max();
  for (const auto& values : { std::vector<double>{ most, 0.9 * most, most, most },
         { -most, -0.9 * most, -most, -most }, { -most, most, 0.0, most } })
  {
    ScalarRange range;
    const auto array = arrayOf(VTK_DOUBLE, values);
    const std::array<float, 4> stored = storedOf(array, range);
    const StoredValues ofLattice = storedOf(array);
    if (values[0] != values[2])
    {
      EXPECT_EQ(stored, (std::array<float, 4>{ { 0.0f, 1.0f, 0.5f, 1.0f } }));
      EXPECT_EQ(ofLattice.Floats, (std::vector<float>{ 0.0f, 1.0f, 0.5f, 1.0f }));
    }
    for (const ScalarRange& found : { range, ofLattice.Range })
    {
      EXPECT_LE(found.Low, found.High);
      EXPECT_TRUE(std::isfinite(found.width()) && std::isfinite(found.Low + found.High));
    }
  }
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
