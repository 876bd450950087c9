// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Curved cells in tetrahedra: without gaps and overlaps, and within the tolerance, against the
// shape functions of the cells.
#include "Curved/Tessellation.h"

#include "FilledCube.h"
#include "GridTransforms.h"
#include "LagrangeGrids.h"
#include "QuadraticGrids.h"

#include "Geometry/Vector3.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

double parabola(double x, double y, double z)
{
  return 0.2 + 2 * (x - 0.5) * (x - 0.5) - y * z + 0.4 * y * y;
}

constexpr double Curvature = 0.1;

struct CurvedCase
{
  const char* Name;
  Grid (*Make)(double curvature);
};

void PrintTo(const CurvedCase& curved, std::ostream* os) { *os << curved.Name; }

vtkSmartPointer<vtkUnstructuredGrid> cut(vtkUnstructuredGrid* grid, double distance, double value,
  bool withScalars = true, CurvedDeparture* departure = nullptr)
{
  auto output = vtkSmartPointer<vtkUnstructuredGrid>::New();
  CurvedTolerance tolerance{ distance, nullptr, {} };
  if (withScalars)
  {
    tolerance.Scalars = grid->GetPointData()->GetScalars();
    tolerance.Values.assign(
      static_cast<std::size_t>(tolerance.Scalars->GetNumberOfComponents()), value);
  }
  EXPECT_EQ(tessellate(
              grid, tolerance, [](double) { return true; }, output, departure),
    "");
  return output;
}

// The scalar of a cell by its shape functions, at a place in space: parameters by Newton's method.
class ShapeFunctions
{
public:
  explicit ShapeFunctions(vtkUnstructuredGrid* grid)
    : Grid(grid)
  {
  }

  double valueAt(vtkIdType cell, const Vector3& point)
  {
    this->Grid->GetCell(cell, this->Cell);
    this->Weights.resize(static_cast<std::size_t>(this->Cell->GetNumberOfPoints()));
    Vector3 at;
    this->Cell->GetParametricCenter(at.data());
    for (int i = 0; i < 20; ++i)
    {
      constexpr double Step = 1e-6;
      const Vector3 off = point - this->positionAt(at);
      std::array<Vector3, 3> columns;
      for (int k = 0; k < 3; ++k)
      {
        Vector3 ahead = at;
        Vector3 behind = at;
        ahead[k] += Step;
        behind[k] -= Step;
        columns[k] = scaled(0.5 / Step, this->positionAt(ahead) - this->positionAt(behind));
      }
      const double whole = dot(columns[0], cross(columns[1], columns[2]));
      for (int k = 0; k < 3; ++k)
      {
        at[k] += dot(off, cross(columns[(k + 1) % 3], columns[(k + 2) % 3])) / whole;
      }
    }
    const Vector3 left = point - this->positionAt(at);
    EXPECT_LT(dot(left, left), 1e-16);
    double value = 0;
    for (std::size_t i = 0; i < this->Weights.size(); ++i)
    {
      value += this->Weights[i] * this->Grid->GetPointData()->GetScalars()->GetComponent(
                                    this->Cell->GetPointId(static_cast<int>(i)), 0);
    }
    return value;
  }

private:
  Vector3 positionAt(const Vector3& at)
  {
    Vector3 position;
    int part = 0;
    this->Cell->EvaluateLocation(part, at.data(), position.data(), this->Weights.data());
    return position;
  }

  vtkUnstructuredGrid* Grid;
  vtkNew<vtkGenericCell> Cell;
  std::vector<double> Weights;
};

// The greatest difference between the tetrahedra and the cells, at points at random.
double greatestError(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* tets,
  const std::vector<vtkIdType>& origins, int samples)
{
  std::mt19937 random(1);
  ShapeFunctions shapes(grid);
  double greatest = 0;
  for (int i = 0; i < samples; ++i)
  {
    const vtkIdType cell = random() % tets->GetNumberOfCells();
    double sum = 0;
    std::array<double, 4> shares;
    for (double& share : shares)
    {
      share = 1e-3 + random() / 4294967296.0;
      sum += share;
    }
    Vector3 point{};
    double value = 0;
    const std::array<vtkIdType, 4> tet = tetrahedron(tets, cell);
    for (int k = 0; k < 4; ++k)
    {
      add(shares[k] / sum, pointOf(tets, tet[k]), point);
      value += shares[k] / sum * tets->GetPointData()->GetScalars()->GetComponent(tet[k], 0);
    }
    greatest = std::max(greatest, std::abs(value - shapes.valueAt(origins[cell], point)));
  }
  return greatest;
}

double parabolaAt(const Vector3& p) { return parabola(p[0], p[1], p[2]); }

// How far a function is from straight lines in the middles of all edges.
double greatestErrorOfMiddles(vtkUnstructuredGrid* tets, double (*valueOf)(const Vector3&))
{
  double greatest = 0;
  for (vtkIdType cell = 0; cell < tets->GetNumberOfCells(); ++cell)
  {
    const std::array<vtkIdType, 4> tet = tetrahedron(tets, cell);
    for (int i = 0; i < 3; ++i)
    {
      const Vector3 begin = pointOf(tets, tet[i]);
      for (int j = i + 1; j < 4; ++j)
      {
        const Vector3 end = pointOf(tets, tet[j]);
        Vector3 middle = scaled(0.5, begin);
        add(0.5, end, middle);
        greatest =
          std::max(greatest, std::abs(valueOf(middle) - 0.5 * (valueOf(begin) + valueOf(end))));
      }
    }
  }
  return greatest;
}

std::vector<vtkIdType> originsOf(vtkUnstructuredGrid* tets)
{
  vtkDataArray* array = tets->GetCellData()->GetArray("vtkOriginalCellIds");
  std::vector<vtkIdType> origins;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    origins.push_back(static_cast<vtkIdType>(array->GetComponent(i, 0)));
  }
  return origins;
}

class CurvedCells : public ::testing::TestWithParam<CurvedCase>
{
};

// Those whose shape functions have the parabola among them.
class CellsOfParabolas : public CurvedCells
{
};

TEST_P(CurvedCells, FillTheCube)
{
  for (const double curvature : { 0.0, Curvature })
  {
    const Grid grid = GetParam().Make(curvature);
    for (const double tolerance : { 1.0, 0.03, 0.01 })
    {
      SCOPED_TRACE(tolerance);
      expectFillsTheCube(cut(grid, tolerance, tolerance));
    }
  }
}

// On edges it is the tolerance, and within tetrahedra 1.5 times it.
TEST_P(CellsOfParabolas, KeepTheToleranceOfScalars)
{
  const Grid grid = GetParam().Make(0);
  for (const double tolerance : { 0.1, 0.01, 0.004 })
  {
    const auto tets = cut(grid, 1, tolerance);
    const double error = greatestError(grid, tets, originsOf(tets), 1000);
    EXPECT_LT(error, 1.5 * tolerance);
    EXPECT_LT(greatestErrorOfMiddles(tets, parabolaAt), tolerance * (1 + 1e-9));
    EXPECT_GT(error, tolerance / 10); // it isn't finer than was asked for
  }
}

// What is moved by the tolerance has the value of a place beside it.
TEST_P(CurvedCells, KeepBothTolerances)
{
  constexpr double GreatestGradient = 3; // of the parabola, in cells that bend
  const Grid grid = GetParam().Make(Curvature);
  double last = 1;
  for (const double tolerance : { 0.03, 0.003 })
  {
    const auto tets = cut(grid, tolerance, tolerance);
    const double error = greatestError(grid, tets, originsOf(tets), 1000);
    EXPECT_LT(error, (1 + GreatestGradient) * tolerance);
    EXPECT_LT(error, last / 2);
    last = error;
  }
}

// At points at random, the scalars of tetrahedra are as far from those of cells as was measured.
TEST_P(CurvedCells, AreMeasured)
{
  for (const double curvature : { 0.0, Curvature })
  {
    const Grid grid = GetParam().Make(curvature);
    for (const double tolerance : { 0.03, 0.003 })
    {
      CurvedDeparture departure;
      const auto tets = cut(grid, tolerance, tolerance, true, &departure);
      const double error = greatestError(grid, tets, originsOf(tets), 1000);
      EXPECT_LT(error, departure.Value) << curvature << ", " << tolerance;
      EXPECT_LT(departure.Value, 6 * error);
      EXPECT_EQ(departure.Distance > 1e-6, curvature > 0);
      EXPECT_LT(departure.Distance, 2 * tolerance);
    }
  }
}

// However cells bend, their tetrahedra have the same linear function of the place.
TEST(Tessellation, IsExactForLinearScalars)
{
  CurvedDeparture departure;
  cut(quadraticHexLattice(2, Curvature), 0.01, 0.1, true, &departure);
  EXPECT_GT(departure.Distance, 1e-3);
  EXPECT_LT(departure.Value, 1e-6);
}

double distanceFromMiddle(const Vector3& p)
{
  const Vector3 away = p - Vector3{ { 0.5, 0.5, 0.5 } };
  return std::sqrt(dot(away, away));
}

// Of a vector that is linear: its magnitude is not, which may be what is drawn.
TEST(Tessellation, MeasuresMagnitudes)
{
  const Grid grid = quadraticTetLattice(2);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const Vector3 p = pointOf(grid, i);
    vectors->InsertNextTuple3(p[0] - 0.5, p[1] - 0.5, p[2] - 0.5);
  }
  grid->GetPointData()->SetScalars(vectors);
  CurvedDeparture departure;
  const auto tets = cut(grid, 1, 1, true, &departure);
  EXPECT_EQ(tets->GetNumberOfCells(), 48);
  const double ofMiddles = greatestErrorOfMiddles(tets, distanceFromMiddle);
  EXPECT_GT(ofMiddles, 0.1);
  EXPECT_NEAR(departure.Value, 1.5 * ofMiddles, 1e-6);
}

// A shape that bends is cut without scalars, too; one that doesn't is one piece for each corner.
TEST_P(CurvedCells, AreCutByTheirShapeAlone)
{
  const Grid straight = GetParam().Make(0);
  const Grid bent = GetParam().Make(Curvature);
  const vtkIdType least = cut(straight, 1e-3, 0, false)->GetNumberOfCells();
  EXPECT_LE(least, 6 * straight->GetNumberOfCells());
  EXPECT_GT(cut(bent, 1e-3, 0, false)->GetNumberOfCells(), 4 * least);
}

const auto Parabolas = ::testing::Values(
  CurvedCase{ "Tetrahedra", [](double c) { return quadraticTetLattice(2, c, parabola); } },
  CurvedCase{ "Hexahedra", [](double c) { return quadraticHexLattice(2, c, parabola); } },
  CurvedCase{ "HexahedraOf27", [](double c) { return triQuadraticHexLattice(2, c, parabola); } },
  CurvedCase{ "Wedges", [](double c) { return quadraticWedgeLattice(2, c, parabola); } },
  CurvedCase{ "LagrangeTetrahedra",
    [](double c) {
      return lagrangeLattice(VTK_LAGRANGE_TETRAHEDRON, 2, { { 3, 3, 3 } }, c, parabola);
    } },
  CurvedCase{ "LagrangeHexahedra",
    [](double c) {
      return lagrangeLattice(VTK_LAGRANGE_HEXAHEDRON, 2, { { 2, 3, 4 } }, c, parabola);
    } },
  CurvedCase{ "LagrangeWedges",
    [](double c) {
      return lagrangeLattice(VTK_LAGRANGE_WEDGE, 2, { { 3, 3, 2 } }, c, parabola);
    } },
  CurvedCase{ "TetrahedraWithPointsOfTheirOwn",
    [](double c) { return withRepeatedPoints(quadraticTetLattice(2, c, parabola)); } },
  CurvedCase{ "HexahedraWithPointsOfTheirOwn",
    [](double c) { return withRepeatedPoints(triQuadraticHexLattice(2, c, parabola)); } });

const auto nameOf = [](const ::testing::TestParamInfo<CurvedCase>& tested)
{ return tested.param.Name; };

INSTANTIATE_TEST_SUITE_P(Of, CurvedCells, Parabolas, nameOf);
INSTANTIATE_TEST_SUITE_P(Of, CellsOfParabolas, Parabolas, nameOf);
INSTANTIATE_TEST_SUITE_P(And, CurvedCells,
  ::testing::Values(
    CurvedCase{ "Pyramids", [](double c) { return quadraticPyramidLattice(2, c, parabola); } },
    CurvedCase{ "TetrahedraWithJumps",
      [](double c) { return withJumps(quadraticTetLattice(2, c, parabola), 0.1); } },
    CurvedCase{ "WedgesWithJumps",
      [](double c) { return withJumps(quadraticWedgeLattice(2, c, parabola), 0.1); } }),
  nameOf);

TEST(Tessellation, EndsWhereItIsToldTo)
{
  const Grid grid = quadraticTetLattice(7, Curvature);
  vtkNew<vtkUnstructuredGrid> output;
  int calls = 0;
  EXPECT_EQ(tessellate(
              grid, { 1e-3, nullptr, {} },
              [&calls](double done)
              {
                EXPECT_LT(done, 1);
                return ++calls < 2;
              },
              output),
    "");
  EXPECT_EQ(calls, 2); // of three
}

// However much they do, and where they are no numbers.
TEST(Tessellation, EndsWithScalarsOfAnySize)
{
  const Grid grid = quadraticTetLattice(1);
  vtkDataArray* scalars = grid->GetPointData()->GetScalars();
  scalars->FillComponent(0, 0);
  scalars->SetComponent(0, 0, 1e9);
  const auto tets = cut(grid, 1, 1e6);
  expectFillsTheCube(tets);
  scalars->SetComponent(0, 0, std::nan(""));
  expectFillsTheCube(cut(grid, 1, 1e-3));
}

} // namespace
