// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Grids as programs of finite elements write them: cells of any degree, each with points of its
// own, and fields that jump between them.
#include "Mesh/Decomposition.h"
#include "Shot.h"

#include "LagrangeGrids.h"

#include "vtkCellType.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr int N = 3;
constexpr double Curvature = 0.1;

struct Written
{
  const char* Name;
  Grid Data;
  std::size_t BoundaryFaces;
};

std::size_t facesOfCube(int parts) { return 12u * N * N * parts * parts; }

std::vector<Written> everyWay()
{
  std::vector<Written> all;
  for (const int degree : { 1, 2, 3 })
  {
    const std::array<int, 3> degrees{ { degree, degree, degree } };
    for (const auto& [name, type] : { std::pair{ "Lagrange hexahedra", VTK_LAGRANGE_HEXAHEDRON },
           std::pair{ "Lagrange wedges", VTK_LAGRANGE_WEDGE },
           std::pair{ "Lagrange tetrahedra", VTK_LAGRANGE_TETRAHEDRON } })
    {
      all.push_back({ name, withRepeatedPoints(lagrangeLattice(type, N, degrees, Curvature)),
        facesOfCube(degree) });
    }
    all.push_back({ "patches", patchLattice(N, degree, Curvature), facesOfCube(degree) });
  }
  all.push_back({ "quadratic tetrahedra", withRepeatedPoints(quadraticTetLattice(N, Curvature)),
    facesOfCube(2) });
  all.push_back({ "hexahedra of three degrees",
    withRepeatedPoints(lagrangeLattice(VTK_LAGRANGE_HEXAHEDRON, N, { 1, 2, 3 }, Curvature)),
    4u * N * N * (1 * 2 + 2 * 3 + 3 * 1) });
  all.push_back({ "wedges of two degrees",
    withRepeatedPoints(lagrangeLattice(VTK_LAGRANGE_WEDGE, N, { 2, 2, 1 }, Curvature)),
    4u * N * N * (2 * 2 + 2 * 1 + 1 * 2) });
  return all;
}

// The points of each cell have the field and a number of their own.
void addJumps(vtkUnstructuredGrid* grid)
{
  std::mt19937 generator(3);
  vtkDataArray* f = grid->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < f->GetNumberOfTuples(); ++i)
  {
    f->SetComponent(i, 0, f->GetComponent(i, 0) + 0.2 * uniform(generator));
  }
}

// The cell's own point at a place.
vtkIdType pointAt(vtkUnstructuredGrid* grid, vtkIdType cell, vtkIdType place)
{
  Vec3 wanted;
  grid->GetPoint(place, wanted.data());
  for (const vtkIdType point : *grid->GetCell(cell)->GetPointIds())
  {
    Vec3 p;
    grid->GetPoint(point, p.data());
    if (p == wanted)
    {
      return point;
    }
  }
  ADD_FAILURE() << "cell " << cell << " has no point where " << place << " is";
  return place;
}

// Tetrahedra without a common point, which a brute force over all of them can draw.
Grid tetrahedraApart(vtkUnstructuredGrid* grid)
{
  Decomposition cut;
  bool stopped = false;
  EXPECT_EQ(decompose(grid, {}, cut, stopped), "");
  EXPECT_TRUE(cut.CenterCells.empty());
  GridBuilder builder;
  std::vector<double> values;
  for (std::size_t t = 0; t < cut.Tets.size(); ++t)
  {
    Ids ids;
    for (const Id corner : cut.Tets[t])
    {
      const vtkIdType point = pointAt(grid, cut.Cells[t], corner);
      Vec3 p;
      grid->GetPoint(point, p.data());
      ids.push_back(builder.addPoint(p));
      values.push_back(grid->GetPointData()->GetScalars()->GetComponent(point, 0));
    }
    builder.addCell(VTK_TETRA, ids);
  }
  const Grid tets = builder.finish(linearField());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    tets->GetPointData()->GetScalars()->SetComponent(static_cast<vtkIdType>(i), 0, values[i]);
  }
  return tets;
}

TEST(FiniteElementGrids, AreLinkedAndFillTheCube)
{
  for (const Written& written : everyWay())
  {
    SCOPED_TRACE(written.Name);
    const TetMesh mesh = built(written.Data);
    EXPECT_EQ(mesh.BoundaryFaces.size(), written.BoundaryFaces);
    EXPECT_NEAR(totalVolume(mesh), 1.0, 1e-6);
    EXPECT_EQ(describe(mesh.Report), "");
  }
}

TEST(FiniteElementGrids, AreDrawnAsByBruteForce)
{
  for (const Written& written : everyWay())
  {
    SCOPED_TRACE(written.Name);
    addJumps(written.Data);
    Shot shot;
    shot.Data = tetrahedraApart(written.Data);
    const Image truth = byGroundTruth(shot);
    shot.Data = written.Data;
    EXPECT_FALSE(MarchedShot(shot, DefaultAccuracy).Scalars.OfCorners.empty());
    MarchCounters counters;
    const Image marched = byReference<double>(shot, GroundTruthAccuracy, counters);
    EXPECT_EQ(counters.Refused + counters.Lost + counters.Guarded, 0);
    const Difference difference = compare(marched, truth);
    EXPECT_LE(difference.Max, 1e-4) << difference.text();
  }
}
} // namespace
