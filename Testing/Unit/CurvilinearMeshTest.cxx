// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The computed cells of a curvilinear grid are those of its hexahedra, with their links.
#include "Mesh/CurvilinearMesh.h"
#include "Mesh/MeshSizes.h"
#include "Mesh/Orientation.h"

#include "CurvilinearGrids.h"
#include "MarchedMesh.h"
#include "MeshConventions.h"

#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <numeric>
#include <set>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr std::array<int, 3> Sizes[] = { { 1, 1, 1 }, { 2, 3, 4 }, { 7, 1, 2 }, { 1, 5, 1 } };

TetMesh computed(vtkStructuredGrid* grid)
{
  TetMesh mesh;
  std::string error;
  EXPECT_EQ(buildCurvilinearMesh(grid, {}, mesh, error), BuildStatus::Done);
  EXPECT_EQ(error, "");
  return mesh;
}

using Points = std::vector<Id>; // ascending

// Each tetrahedron, or each boundary face, by its points of the grid; with its cell behind.
std::set<Points> tetsOf(const TetMesh& mesh)
{
  std::set<Points> tets;
  for (std::size_t t = 0; t < mesh.Tets.size(); ++t)
  {
    Points points;
    for (const Id vertex : mesh.Tets[t])
    {
      points.push_back(mesh.VertexPoints[vertex]);
    }
    std::sort(points.begin(), points.end());
    points.push_back(mesh.TetCells[t]);
    EXPECT_TRUE(tets.insert(points).second);
  }
  return tets;
}

// From outside counter-clockwise, the lowest point first.
std::set<Points> facesOf(const TetMesh& mesh)
{
  std::set<Points> faces;
  for (const auto& face : mesh.BoundaryFaces)
  {
    Points points;
    for (int i = 0; i < 3; ++i)
    {
      points.push_back(mesh.VertexPoints[face[i]]);
    }
    std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
    EXPECT_TRUE(faces.insert(points).second);
  }
  return faces;
}

TEST(CurvilinearMesh, IsThatOfItsHexahedra)
{
  for (const NamedMovement& movement : everyMovement())
  {
    for (const auto& size : Sizes)
    {
      SCOPED_TRACE(std::string(movement.Name) + ", " + std::to_string(size[0]) + " x " +
                   std::to_string(size[1]) + " x " + std::to_string(size[2]));
      const auto grid = curvilinearGrid(size, movement.Move);
      const TetMesh mesh = computed(grid);
      if (!movement.Computed)
      {
        EXPECT_TRUE(mesh.Tets.empty());
        EXPECT_FALSE(mesh.Curvilinear);
        continue;
      }
      if (mesh.Tets.empty()) // few cells may be turned too far
      {
        EXPECT_EQ(movement.Name, std::string("three quarters of a ring"));
        continue;
      }
      const TetMesh stored = built(hexahedraOf(grid));
      expectConventions(mesh);
      EXPECT_EQ(tetsOf(mesh), tetsOf(stored));
      EXPECT_EQ(facesOf(mesh), facesOf(stored));
      EXPECT_EQ(mesh.NeedsHierarchy, stored.NeedsHierarchy);
      TetMesh searched = mesh;
      ensureHierarchy(searched);
      expectConventions(searched);
      expectConventions(mesh); // which shares nothing with it that is changed
    }
  }
}

// At most 24 bytes a hexahedron on the GPU (16 of its point), cells with scalars included.
TEST(CurvilinearMesh, TakesFewBytes)
{
  for (const bool ofCells : { false, true })
  {
    const TetMesh mesh = computed(curvilinearGrid({ 100, 100, 100 }, everyMovement()[2].Move));
    const std::size_t cells = 100 * 100 * 100;
    const auto sizes = bufferSizes(mesh, ofCells ? cells : 0, cells * 6 / 32);
    const std::uint64_t bytes = std::accumulate(sizes.begin(), sizes.end(), std::uint64_t(0),
      [](std::uint64_t sum, const BufferSize& size)
      { return sum + size.Texels * size.BytesPerTexel; });
    EXPECT_LE(double(bytes) / cells, ofCells ? 28.0 : 24.0);
    std::cout << "[ MEASURED ] bytes of a hexahedron" << (ofCells ? ", scalars of cells: " : ": ")
              << double(bytes) / cells << "\n";
  }
}
} // namespace
