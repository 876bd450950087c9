// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Pieces of a grid fit together to the last bit, and have the gradients of the whole.
#include "Pieces.h"
#include "ThreadGroup.h"

#include "Mesh/Gradients.h"
#include "Mesh/TetMeshBuilder.h"

#include "CellTypeGrids.h"
#include "GridTransforms.h"
#include "LatticeGrids.h"

#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr int Processes = 3;

TetMesh built(vtkUnstructuredGrid* grid, const PieceOptions& piece)
{
  TetMesh mesh;
  std::string error;
  EXPECT_EQ(buildTetMesh(grid, {}, mesh, error, piece), BuildStatus::Done) << error;
  return mesh;
}

PieceOptions piecesOf(vtkUnstructuredGrid* grid)
{
  PieceOptions piece;
  piece.ByCoordinates = true;
  piece.IsPiece = true;
  piece.Frame = built(grid, {}).Frame;
  return piece;
}

using Place = std::array<float, 3>;
using Triangle = std::array<Place, 3>;

Place placeOf(const Vertex& v) { return { { v.X, v.Y, v.Z } }; }

// How often each triangle of the boundary occurs.
void countFaces(const TetMesh& mesh, std::map<Triangle, int>& counts)
{
  for (const auto& face : mesh.BoundaryFaces)
  {
    Triangle triangle;
    for (int k = 0; k < 3; ++k)
    {
      triangle[k] = placeOf(mesh.Vertices[face[k]]);
    }
    std::sort(triangle.begin(), triangle.end());
    ++counts[triangle];
  }
}

// Of the boundaries of pieces what is no boundary of the whole is there twice.
void expectToFit(vtkUnstructuredGrid* whole, const std::vector<Grid>& pieces, PieceOptions options)
{
  std::map<Triangle, int> outside, faces;
  countFaces(built(whole, options), outside);
  for (const Grid& piece : pieces)
  {
    countFaces(built(piece, options), faces);
  }
  std::size_t shared = 0;
  for (const auto& [triangle, count] : faces)
  {
    ASSERT_EQ(count, outside.count(triangle) ? 1 : 2);
    shared += outside.count(triangle) ? 0 : 1;
  }
  for (const auto& [triangle, count] : outside)
  {
    ASSERT_EQ(faces.count(triangle), 1u);
  }
  EXPECT_GT(shared, 100u);
}

std::vector<Grid> piecesOf(vtkUnstructuredGrid* grid, unsigned int seed)
{
  std::vector<Grid> pieces;
  for (int p = 0; p < Processes; ++p)
  {
    pieces.push_back(pieceOf(grid, randomPartition(Processes, seed), p));
  }
  return pieces;
}

TEST(Pieces, OfEveryKindOfCellHaveTheSameFaces)
{
  const std::vector<Grid> grids{ jitteredLattice(5), hexLattice(5, 0.2), wedgeLattice(5, 0.1),
    pyramidLattice(4, 0.1), polyhedronLattice(4, 0.1), mixedCells(4, 1, 0.1) };
  for (std::size_t i = 0; i < grids.size(); ++i)
  {
    SCOPED_TRACE("grid " + std::to_string(i));
    const auto seed = static_cast<unsigned int>(i);
    expectToFit(grids[i], piecesOf(grids[i], seed), piecesOf(grids[i]));
    expectToFit(grids[i], piecesOf(withRepeatedPoints(grids[i]), seed), piecesOf(grids[i]));
  }
}

TEST(Pieces, FarFromTheOriginHaveTheSameFaces)
{
  const Grid grid = withOffsetAndScale(hexLattice(5, 0.2), { { 1e6, -2e6, 3e5 } }, 1.0 / 3.0);
  expectToFit(grid, piecesOf(grid, 7), piecesOf(grid));
}

Grid inFloat(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, grid->GetPoint(i));
  }
  const auto copy = Grid::New();
  copy->ShallowCopy(grid);
  copy->SetPoints(points);
  return copy;
}

TEST(Pieces, InFloatAndInDoubleHaveTheSameFaces)
{
  const Grid grid = withOffsetAndScale(hexLattice(5, 0.2), { { 0.1, 0.2, 0.3 } }, 1.0 / 3.0);
  std::vector<Grid> pieces = piecesOf(grid, 3);
  pieces[1] = inFloat(pieces[1]);
  PieceOptions options = piecesOf(grid);
  options.InFloat = true;
  expectToFit(grid, pieces, options);
}

// A wave, so that gradients differ from vertex to vertex.
void setWave(TetMesh& mesh)
{
  for (Vertex& v : mesh.Vertices)
  {
    v.Scalar = 0.5f + 0.4f * std::sin(4.0f * v.X + 3.0f * v.Y * v.Z);
  }
}

std::vector<float> waveOfCells(const TetMesh& mesh)
{
  std::vector<float> scalars;
  for (const auto& tet : mesh.Tets)
  {
    float sum = 0;
    for (const Id v : tet)
    {
      sum += 0.25f * mesh.Vertices[v].Scalar;
    }
    scalars.push_back(sum);
  }
  return scalars;
}

std::vector<Gradient> gradientsOf(const TetMesh& mesh, bool ofCells, Group* group)
{
  return ofCells ? vertexGradients(mesh, waveOfCells(mesh), group) : vertexGradients(mesh, group);
}

TEST(Pieces, HaveTheGradientsOfTheWhole)
{
  for (const bool ofCells : { false, true })
  {
    const Grid grid = jitteredLattice(7);
    const PieceOptions options = piecesOf(grid);
    TetMesh whole = built(grid, options);
    setWave(whole);
    const std::vector<Gradient> expected = gradientsOf(whole, ofCells, nullptr);
    std::map<Place, Gradient> there;
    for (std::size_t v = 0; v < expected.size(); ++v)
    {
      there[placeOf(whole.Vertices[v])] = expected[v];
    }
    std::vector<TetMesh> meshes;
    for (const Grid& piece : piecesOf(grid, 5))
    {
      meshes.push_back(built(piece, options));
      setWave(meshes.back());
    }
    runTogether(Processes,
      [&](Group& group)
      {
        const TetMesh& mesh = meshes[group.rank()];
        const std::vector<Gradient> together = gradientsOf(mesh, ofCells, &group);
        const std::vector<Gradient> alone = gradientsOf(mesh, ofCells, nullptr);
        double worst = 0, worstAlone = 0;
        for (std::size_t v = 0; v < together.size(); ++v)
        {
          const Gradient& right = there.at(placeOf(mesh.Vertices[v]));
          for (int k = 0; k < 3; ++k)
          {
            worst = std::max(worst, std::abs(double(together[v][k]) - double(right[k])));
            worstAlone = std::max(worstAlone, std::abs(double(alone[v][k]) - double(right[k])));
          }
        }
        EXPECT_LT(worst, 1e-5);
        EXPECT_GT(worstAlone, 0.1); // the test can fail
      });
  }
}

} // namespace
