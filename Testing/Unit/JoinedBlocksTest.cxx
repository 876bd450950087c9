// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Blocks become the grid that they were cut from, whatever they are and however they are nested.
#include "AdaptiveMeshes.h"
#include "Grids.h"
#include "JoinedGrids.h"
#include "Mesh/MeshScalars.h"
#include "Mesh/TetMeshBuilder.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOverlappingAMR.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

TetMesh meshOf(vtkUnstructuredGrid* grid)
{
  TetMesh mesh;
  std::string error;
  EXPECT_EQ(buildTetMesh(grid, {}, mesh, error), BuildStatus::Done) << error;
  return mesh;
}

vtkSmartPointer<vtkUnsignedCharArray> ghosts(vtkIdType count, unsigned char value)
{
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetName(vtkDataSetAttributes::GhostArrayName());
  array->SetNumberOfTuples(count);
  array->Fill(value);
  return array;
}

// A tetrahedron with a scalar of its own, whose face of x = 0 all of them share.
Grid tetTowards(double x, double scalar)
{
  GridBuilder builder;
  builder.addCell(VTK_TETRA, { builder.at(0, 0, 0), builder.at(0, 1, 0), builder.at(0, 0, 1),
                               builder.addPoint({ x, 0.0, 0.0 }) });
  return builder.finish(constantField(scalar));
}

TEST_F(Joined, BlocksAreWhatTheyWereCutFrom)
{
  const std::vector<Grid> grids = { jitteredLattice(6), mixedCells(4), hexLattice(4, 0.1),
    polyhedronLattice(4, 0.1), voxelLattice(4), withFloatPoints(jitteredLattice(6)) };
  for (std::size_t g = 0; g < grids.size(); ++g)
  {
    const TetMesh whole = meshOf(grids[g]);
    for (const int parts : { 2, 3, 8 })
    {
      for (const bool globalIds : { false, true })
      {
        SCOPED_TRACE(std::to_string(g) + " in " + std::to_string(parts));
        this->join(cutIntoBlocks(grids[g], partsOfUnitCube(parts), globalIds));
        EXPECT_EQ(this->grid()->GetNumberOfPoints(), grids[g]->GetNumberOfPoints());
        EXPECT_EQ(this->grid()->GetNumberOfCells(), grids[g]->GetNumberOfCells());
        EXPECT_EQ(this->grid()->GetPoints()->GetDataType(), grids[g]->GetPoints()->GetDataType());
        const TetMesh mesh = meshOf(this->grid());
        EXPECT_EQ(mesh.Tets.size(), whole.Tets.size());
        EXPECT_EQ(mesh.BoundaryFaces.size(), whole.BoundaryFaces.size());
        EXPECT_EQ(mesh.MayReenter, whole.MayReenter);
        ASSERT_EQ(this->Blocks.scalars()->GetNumberOfTuples(), whole.NumberOfPoints);
        EXPECT_EQ(this->Blocks.omissions(), "");
      }
    }
  }
}

TEST_F(Joined, ScalarsGoAlong)
{
  const Grid whole = jitteredLattice(4, 0.15, 1, linearField());
  const Field field = linearField();
  const std::vector<Grid> cut = cutIntoBlocks(whole, partsOfUnitCube(8));
  this->join(cut, pointArray("f"));
  EXPECT_FALSE(this->Blocks.hasCellScalars());
  EXPECT_STREQ(this->Blocks.scalars()->GetName(), "f");
  for (vtkIdType i = 0; i < this->grid()->GetNumberOfPoints(); ++i)
  {
    const double* p = this->grid()->GetPoint(i);
    EXPECT_EQ(this->Blocks.scalars()->GetComponent(i, 0), field(p[0], p[1], p[2]));
  }
  this->join(cut, cellArray("c"));
  EXPECT_TRUE(this->Blocks.hasCellScalars());
  vtkIdType cell = 0;
  for (const Grid& block : cut)
  {
    for (vtkIdType i = 0; i < block->GetNumberOfCells(); ++i, ++cell)
    {
      EXPECT_EQ(this->Blocks.scalars()->GetComponent(cell, 0),
        block->GetCellData()->GetScalars()->GetComponent(i, 0));
    }
  }
  EXPECT_EQ(cell, this->Blocks.scalars()->GetNumberOfTuples());
}

TEST_F(Joined, TypesOfScalarsMayDiffer)
{
  const std::vector<Grid> cut = { tetTowards(-1.0, 0.25), tetTowards(1.0, 0.75) };
  for (vtkDataSetAttributes* attributes :
    std::initializer_list<vtkDataSetAttributes*>{ cut[1]->GetPointData(), cut[1]->GetCellData() })
  {
    const vtkSmartPointer<vtkDataArray> doubles = attributes->GetScalars();
    vtkNew<vtkFloatArray> floats;
    floats->DeepCopy(doubles);
    attributes->SetScalars(floats);
  }
  for (const ScalarSelection& selection : { pointArray("f"), cellArray("c") })
  {
    this->join(cut, selection);
    vtkDataArray* scalars = this->Blocks.scalars();
    EXPECT_EQ(scalars->GetComponent(0, 0), 0.25);
    EXPECT_EQ(scalars->GetComponent(scalars->GetNumberOfTuples() - 1, 0), 0.75);
  }
}

TEST_F(Joined, GlobalIdsWinOverCoordinates)
{
  const Grid whole = jitteredLattice(4);
  for (const bool globalIds : { false, true })
  {
    std::vector<Grid> cut = cutIntoBlocks(whole, partsOfUnitCube(2), globalIds);
    vtkDataArray* points = cut[1]->GetPoints()->GetData();
    for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
    {
      points->SetComponent(i, 0, std::nextafter(points->GetComponent(i, 0), 2.0));
    }
    this->join(cut);
    EXPECT_EQ(this->grid()->GetNumberOfPoints(), globalIds ? 125 : 125 + 25);
    EXPECT_EQ(meshOf(this->grid()).BoundaryFaces.size(), globalIds ? 192u : 192u + 2 * 32);
  }
  // Where one block has none, coordinates count.
  std::vector<Grid> cut = cutIntoBlocks(whole, partsOfUnitCube(2), true);
  cut[0]->GetPointData()->SetGlobalIds(nullptr);
  this->join(cut);
  EXPECT_EQ(this->grid()->GetNumberOfPoints(), 125);
}

TEST_F(Joined, PlusAndMinusZeroAreOnePlace)
{
  const std::vector<Grid> cut = { tetTowards(-1.0, 0.0), tetTowards(1.0, 0.0) };
  for (vtkIdType i = 0; i < 3; ++i)
  {
    cut[1]->GetPoints()->GetData()->SetComponent(i, 0, -0.0);
  }
  this->join(cut);
  EXPECT_EQ(this->grid()->GetNumberOfPoints(), 5);
}

TEST_F(Joined, PointsOfOneBlockStayApart)
{
  // A block of two tetrahedra side by side that share no points, as at a crack, and one with the
  // same crack: four points in each of three places.
  const auto cracked = [](double x) { return joined(tetTowards(x, 0.0), tetTowards(x, 0.0)); };
  this->join({ cracked(-1.0), cracked(1.0) });
  EXPECT_EQ(this->grid()->GetNumberOfPoints(), 2 * 5);
  this->join({ cracked(-1.0), tetTowards(1.0, 0.0) });
  EXPECT_EQ(this->grid()->GetNumberOfPoints(), 8 + 1);
  EXPECT_EQ(this->grid()->GetNumberOfCells(), 3);
}

// Where they differ, blocks keep their scalars; the mesh has one vertex and two corners then.
TEST_F(Joined, EachBlockKeepsItsScalars)
{
  this->join({ tetTowards(-1.0, 0.25), tetTowards(1.0, 0.75) });
  ASSERT_EQ(this->grid()->GetNumberOfPoints(), 8);
  for (vtkIdType cell = 0; cell < 2; ++cell)
  {
    for (const vtkIdType point : *this->grid()->GetCell(cell)->GetPointIds())
    {
      EXPECT_EQ(this->Blocks.scalars()->GetComponent(point, 0), cell == 0 ? 0.25 : 0.75);
    }
  }
  TetMesh mesh = meshOf(this->grid());
  EXPECT_EQ(mesh.Vertices.size(), 5u);
  EXPECT_EQ(mesh.BoundaryFaces.size(), 6u);
  const MeshScalars scalars = readScalars(this->grid(), { this->Blocks.scalars() }, mesh);
  ASSERT_EQ(scalars.OfCorners.size(), 2u);
  for (std::size_t t = 0; t < 2; ++t)
  {
    const float own = mesh.TetCells[t] == 0 ? 0.0f : 1.0f;
    EXPECT_EQ(scalars.OfCorners[t], (std::array<float, 4>{ { own, own, own, own } }));
  }
}

TEST_F(Joined, GhostsStayWhatTheyAre)
{
  const std::vector<Grid> cut = { tetTowards(-1.0, 0.25), tetTowards(1.0, 0.75),
    tetTowards(2.0, 0.5) };
  cut[0]->GetPointData()->AddArray(ghosts(4, vtkDataSetAttributes::DUPLICATEPOINT));
  cut[0]->GetCellData()->AddArray(ghosts(1, vtkDataSetAttributes::DUPLICATECELL));
  this->join(cut);
  // The tip of the first alone; of the second all; of the third, whose scalar is another, all.
  ASSERT_EQ(this->grid()->GetNumberOfPoints(), 1 + 4 + 4);
  auto* ofPoints = vtkUnsignedCharArray::SafeDownCast(
    this->grid()->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  auto* ofCells = vtkUnsignedCharArray::SafeDownCast(
    this->grid()->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  ASSERT_TRUE(ofPoints && ofCells);
  for (vtkIdType cell = 0; cell < 3; ++cell)
  {
    EXPECT_EQ(ofCells->GetValue(cell), cell == 0 ? vtkDataSetAttributes::DUPLICATECELL : 0);
    for (const vtkIdType point : *this->grid()->GetCell(cell)->GetPointIds())
    {
      // The duplicates of the first are points of the second.
      const bool ofFirst = this->grid()->GetPoint(point)[0] < -0.5;
      EXPECT_EQ(ofPoints->GetValue(point), ofFirst ? vtkDataSetAttributes::DUPLICATEPOINT : 0);
      EXPECT_EQ(
        this->Blocks.scalars()->GetComponent(point, 0), ofFirst ? 0.25 : (cell == 2 ? 0.5 : 0.75));
    }
  }
}

TEST_F(Joined, ImagesAndSinglePrecision)
{
  // Voxels from 0 to 1/2 along x, hexahedra beyond, in float.
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 5, 5);
  image->SetSpacing(0.25, 0.25, 0.25);
  vtkNew<vtkDoubleArray> f;
  f->SetName("f");
  f->SetNumberOfTuples(75);
  f->Fill(0.5);
  image->GetPointData()->SetScalars(f);
  const Grid rest = withFloatPoints(
    cutIntoBlocks(hexLattice(4, 0.0, constantField(0.5)), partsOfUnitCube(2)).back());
  vtkNew<vtkMultiBlockDataSet> input;
  input->SetBlock(0, image);
  input->SetBlock(1, rest);
  EXPECT_EQ(this->Blocks.update(input, ActiveScalars), "");
  EXPECT_EQ(this->grid()->GetNumberOfPoints(), 125);
  EXPECT_EQ(this->grid()->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(meshOf(this->grid()).BoundaryFaces.size(), 192u);
}

TEST_F(Joined, NestedWithHolesAndSurfaces)
{
  const std::vector<Grid> cut = cutIntoBlocks(jitteredLattice(4), partsOfUnitCube(8));
  vtkNew<vtkMultiBlockDataSet> input;
  vtkNew<vtkPolyData> surface;
  for (unsigned half = 0; half < 2; ++half)
  {
    vtkNew<vtkMultiBlockDataSet> inner;
    for (unsigned b = 0; b < 4; ++b)
    {
      inner->SetBlock(2 * b + 1, cut[4 * half + b]);
    }
    input->SetBlock(3 * half, inner);
  }
  input->SetBlock(1, surface);
  input->SetBlock(4, triangleAndLineGrid());
  input->SetBlock(5, emptyGrid());
  EXPECT_EQ(this->Blocks.update(input, ActiveScalars), "");
  EXPECT_EQ(this->Blocks.omissions(), "");
  EXPECT_EQ(this->grid()->GetNumberOfPoints(), 125);
  EXPECT_EQ(this->grid()->GetNumberOfCells(), 384);
}

TEST_F(Joined, NothingIsNothing)
{
  vtkNew<vtkMultiBlockDataSet> input;
  EXPECT_EQ(this->Blocks.update(input, ActiveScalars), "");
  EXPECT_EQ(this->grid(), nullptr);
  input->SetNumberOfBlocks(3);
  input->SetBlock(1, triangleAndLineGrid());
  EXPECT_EQ(this->Blocks.update(input, ActiveScalars), "");
  EXPECT_EQ(this->grid(), nullptr);
}

TEST_F(Joined, FinestCellsOfAnAdaptiveMesh)
{
  const auto input = adaptiveMesh(sineField());
  EXPECT_EQ(this->Blocks.update(input, cellArray("c")), "");
  std::array<int, 3> leaves{};
  double volume = 0;
  for (vtkIdType cell = 0; cell < this->grid()->GetNumberOfCells(); ++cell)
  {
    if (this->grid()->GetCellType(cell) != VTK_EMPTY_CELL)
    {
      double box[6];
      this->grid()->GetCellBounds(cell, box);
      const double width = box[1] - box[0];
      ++leaves[static_cast<std::size_t>(std::lround(std::log2(0.25 / width)))];
      volume += width * width * width;
    }
  }
  EXPECT_EQ(leaves, LeavesOfAdaptiveMesh);
  EXPECT_DOUBLE_EQ(volume, 1.0);
  EXPECT_EQ(this->Blocks.scalars()->GetNumberOfTuples(), this->grid()->GetNumberOfCells());
}
} // namespace
