// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which sizes exceed which limits, with sizes and limits that need no such machine.
#include "UnitMeshes.h"

#include "Grids.h"
#include "Mesh/LeastTetrahedra.h"
#include "Mesh/MeshSizes.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdTypeArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr std::uint64_t Texels = 1000;

std::string excess(const std::vector<BufferSize>& sizes, const ResourceLimits& limits,
  SizesAre are = SizesAre::Exact)
{
  return describeExcess(sizes, limits, are);
}

void expectWords(const std::string& text, const std::vector<std::string>& words)
{
  for (const std::string& word : words)
  {
    EXPECT_NE(text.find(word), std::string::npos) << '"' << word << "\" is not in: " << text;
  }
}

TEST(ResourceLimits, ToTheLastTexel)
{
  const ResourceLimits limits{ Texels, 0 };
  EXPECT_EQ(excess({ { "links", Texels, 8 }, { "vertices", Texels, 16 } }, limits), "");
  const std::string error = excess({ { "links", Texels, 8 }, { "vertices", 1001, 16 } }, limits);
  expectWords(
    error, { "1001 texels", "vertices", "takes 1000", "GL_MAX_TEXTURE_BUFFER_SIZE", "coarsen" });
  EXPECT_EQ(error.find("at least"), std::string::npos);
}

TEST(ResourceLimits, ToTheLastTexelOfTheLastBuffer)
{
  const ResourceLimits limits{ Texels, 0 };
  EXPECT_EQ(excess({ { "tetrahedra", 2 * Texels, 16, 2 } }, limits), "");
  expectWords(excess({ { "tetrahedra", 2 * Texels + 1, 16, 2 } }, limits),
    { "2001 texels", "tetrahedra", "takes 2000 (2 x GL_MAX_TEXTURE_BUFFER_SIZE)" });
  expectWords(excess({ { "vertices", 2 * Texels, 16 } }, limits), { "takes 1000 (GL_MAX" });
  // No limit is beyond any number.
  EXPECT_EQ(excess({ { "tetrahedra", ~std::uint64_t(0) / 16, 16, 2 } }, {}), "");
}

TEST(ResourceLimits, ToTheLastByte)
{
  const std::vector<BufferSize> sizes = { { "links", 100, 8 }, { "vertices", 10, 16 } };
  EXPECT_EQ(excess(sizes, { Texels, 960 }), "");
  expectWords(excess(sizes, { Texels, 959 }), { "960 bytes", "959", "MaxMemoryInBytes", "Raise" });
  EXPECT_EQ(excess(sizes, { Texels, 0 }), ""); // no limit
}

TEST(ResourceLimits, LowerBoundsSaySo)
{
  const ResourceLimits limits{ Texels, 5000 };
  const std::uint64_t most = mostTetrahedra(limits);
  EXPECT_EQ(most, 5000u / 16u);
  EXPECT_EQ(excess(leastBufferSizes(most), limits, SizesAre::LowerBounds), "");
  expectWords(excess(leastBufferSizes(most + 1), limits, SizesAre::LowerBounds),
    { "at least 5008 bytes", "allowed are 5000" });
  const ResourceLimits loose{ Texels, 0 };
  EXPECT_EQ(mostTetrahedra(loose), 2000u);
  EXPECT_EQ(excess(leastBufferSizes(2000), loose, SizesAre::LowerBounds), "");
  expectWords(
    excess(leastBufferSizes(2001), loose, SizesAre::LowerBounds), { "at least 2001 texels" });
  // Half-faces have numbers of 32 bits, whatever the GL takes.
  EXPECT_EQ(mostTetrahedra({}), std::uint64_t(1) << 29);
  EXPECT_EQ(mostTetrahedra({ std::uint64_t(1) << 27, 0 }), std::uint64_t(1) << 28);
  EXPECT_EQ(mostTetrahedra({ std::uint64_t(1) << 31, 0 }), std::uint64_t(1) << 29);
}

TEST(ResourceLimits, SizesPastAnyInteger)
{
  const std::uint64_t tets = std::uint64_t(1) << 40;
  expectWords(excess(leastBufferSizes(tets), { std::uint64_t(1) << 27, 0 }, SizesAre::LowerBounds),
    { std::to_string(tets), std::to_string(1 << 28) });
}

TEST(ResourceLimits, OfAMesh)
{
  const TetMesh mesh = builtWithHierarchy(jitteredLattice(3));
  const std::uint64_t tets = mesh.Tets.size();
  // What each tetrahedron has a texel for may be in two buffers, and nothing else.
  for (const BufferSize& size : bufferSizes(mesh, tets, 5))
  {
    EXPECT_EQ(size.MostBuffers, size.Texels == tets ? 2u : 1u) << size.Name;
  }
  std::uint64_t bytes = 0;
  for (const BufferSize& size : bufferSizes(mesh, 7, 5))
  {
    bytes += size.Texels * size.BytesPerTexel;
  }
  EXPECT_EQ(bytes, 16 * mesh.Tets.size() + 16 * mesh.BoundaryFaces.size() +
                     32 * mesh.Hierarchy.size() + 16 * mesh.Vertices.size() + 7 * 4 + 5 * 4);
}

TEST(LeastTetrahedra, IsWhatConvexCellsBecome)
{
  const struct
  {
    Grid Cells;
    int Type;
    int Each;
  } cases[] = { { jitteredLattice(2), VTK_TETRA, 1 }, { hexLattice(2), VTK_HEXAHEDRON, 6 },
    { voxelLattice(2), VTK_VOXEL, 6 }, { wedgeLattice(2), VTK_WEDGE, 3 },
    { pyramidLattice(2), VTK_PYRAMID, 2 }, { pentagonalPrismLattice(2), VTK_PENTAGONAL_PRISM, 9 },
    { hexagonalPrismLattice(2), VTK_HEXAGONAL_PRISM, 12 },
    { quadraticTetLattice(2), VTK_QUADRATIC_TETRA, 8 } };
  for (const auto& c : cases)
  {
    EXPECT_EQ(leastTetrahedraOfType(c.Type), c.Each) << c.Type;
    const std::uint64_t least = leastTetrahedra(c.Cells, 0);
    EXPECT_EQ(least, std::uint64_t(c.Each) * c.Cells->GetNumberOfCells()) << c.Type;
    EXPECT_EQ(least, built(c.Cells).Tets.size()) << c.Type;
  }
}

TEST(LeastTetrahedra, IsNeverMoreThanThereAre)
{
  for (const NamedGrid& named : everyGrid())
  {
    const Grid grid = named.Make();
    const TetMesh mesh = built(grid);
    const std::uint64_t least = leastTetrahedra(grid, 0);
    // Cells that repeat another one are counted.
    EXPECT_LE(least, mesh.Tets.size() + mesh.Report.DuplicateTetrahedra) << named.Name;
    EXPECT_GT(4 * least, mesh.Tets.size() / 4) << named.Name << " is far from it";
    EXPECT_EQ(leastTetrahedra(grid, least), least) << named.Name;
  }
}

TEST(LeastTetrahedra, CollapsedCellsDoNotCount)
{
  const Grid grid = hexLattice(2);
  const vtkIdType tetAsHexahedron[8] = { 0, 1, 3, 3, 9, 9, 9, 9 };
  grid->InsertNextCell(VTK_HEXAHEDRON, 8, tetAsHexahedron);
  EXPECT_EQ(leastTetrahedra(grid, 54), 54u); // by types alone, which is not above
  EXPECT_EQ(leastTetrahedra(grid, 53), 48u);
}

TEST(LeastTetrahedra, ArraysThatDoNotFitTogether)
{
  vtkNew<vtkUnstructuredGrid> bare;
  EXPECT_EQ(leastTetrahedra(bare, 0), 0u);

  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkIdTypeArray> offsets;
  for (vtkIdType i = 0; i < 8; ++i)
  {
    ids->InsertNextValue(1000 * i - 500); // of no points
  }
  for (const vtkIdType offset : { 0, 4, 8, -4, 12, 2 })
  {
    offsets->InsertNextValue(offset);
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, ids);
  vtkNew<vtkUnsignedCharArray> types;
  types->InsertNextValue(VTK_TETRA);
  const Grid grid = Grid::New();
  grid->SetCells(types, cells);
  EXPECT_EQ(leastTetrahedra(grid, 0), 0u);
  for (int i = 1; i < 5; ++i)
  {
    types->InsertNextValue(VTK_TETRA);
  }
  EXPECT_EQ(leastTetrahedra(grid, 100), 5u);
  EXPECT_EQ(leastTetrahedra(grid, 0), 2u);
}
} // namespace
