// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A mesh in blocks looks like the whole: rays go on from block to block.
#include "ErrorScene.h"
#include "GridBlocks.h"
#include "OtherGrid.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkTrivialProducer.h"

#include <cmath>

namespace
{
using namespace tetmarch::testing;

struct Counts
{
  vtkTypeInt64 Rays, Cells, Refused, Lost, Tetrahedra, Faces;
};

Counts countsOf(vtkTetMarchVolumeMapper* mapper)
{
  return { mapper->GetNumberOfRays(), mapper->GetNumberOfCrossedCells(),
    mapper->GetNumberOfRefusedEntries(), mapper->GetNumberOfLostRays(),
    mapper->GetNumberOfTetrahedra(), mapper->GetNumberOfBoundaryFaces() };
}

void expectSameCounts(const Counts& a, const Counts& b)
{
  EXPECT_EQ(a.Rays, b.Rays);
  EXPECT_EQ(a.Cells, b.Cells);
  EXPECT_EQ(a.Refused, b.Refused);
  EXPECT_EQ(a.Lost, 0);
  EXPECT_EQ(b.Lost, 0);
  EXPECT_EQ(a.Tetrahedra, b.Tetrahedra);
  EXPECT_EQ(a.Faces, b.Faces);
}

void moveByLastBit(vtkUnstructuredGrid* grid)
{
  vtkDataArray* points = grid->GetPoints()->GetData();
  for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      points->SetComponent(i, k, std::nextafter(points->GetComponent(i, k), 2.0));
    }
  }
}

TEST(Blocks, LookLikeTheWhole)
{
  const struct
  {
    const char* Name;
    Grid Whole;
    bool CellScalars;
  } cases[] = { { "tetrahedra", jitteredLattice(8, 0.15, 1, sineField()), false },
    { "cell scalars", jitteredLattice(8, 0.15, 1, sineField()), true },
    { "not convex", latticeWithHole(6, 0.15, 1, sineField()), false } };
  for (const auto& c : cases)
  {
    Scene whole(c.Whole);
    Scene scene(c.Whole);
    if (c.CellScalars)
    {
      whole.drawCellScalars();
      scene.drawCellScalars();
    }
    const Image expected = whole.render();
    for (const int parts : { 2, 3, 8 })
    {
      for (const bool globalIds : { false, true })
      {
        SCOPED_TRACE(std::string(c.Name) + " in " + std::to_string(parts));
        std::vector<Grid> cut = cutIntoBlocks(c.Whole, partsOfUnitCube(parts), globalIds);
        if (globalIds)
        {
          moveByLastBit(cut.back());
        }
        const auto input = blocks(cut);
        scene.Mapper->SetInputDataObject(input);
        const Difference difference = compare(scene.render(), expected);
        EXPECT_LE(difference.Max, globalIds ? 1.0 / 255.0 : 0.0);
        expectSameCounts(countsOf(scene.Mapper), countsOf(whole.Mapper));
        std::cout << "[ MEASURED ] " << c.Name << ", " << parts << " blocks: " << difference.text()
                  << "\n";
      }
    }
  }
}

// Where blocks have other values at the points that they share, they are cells with points of their
// own, at which the scalar jumps.
TEST(Blocks, KeepTheirValues)
{
  for (const bool globalIds : { false, true })
  {
    const std::vector<Grid> cut =
      cutIntoBlocks(jitteredLattice(6, 0.15, 1, sineField()), partsOfUnitCube(2), globalIds);
    vtkDataArray* f = cut[1]->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < f->GetNumberOfTuples(); ++i)
    {
      f->SetComponent(i, 0, f->GetComponent(i, 0) + 0.2);
    }
    Scene apart(joined(cut[0], cut[1]));
    Scene scene(jitteredLattice(6));
    scene.Mapper->SetInputDataObject(blocks(cut));
    EXPECT_EQ(compare(scene.render(), apart.render()).Max, 0.0);
    expectSameCounts(countsOf(scene.Mapper), countsOf(apart.Mapper));
  }
}

// Which way other cells are cut depends on the numbers of their points, which makes no difference
// to a linear scalar.
TEST(Blocks, OfOtherCellsLookLikeTheWhole)
{
  const Grid grid = mixedCells(4, 1, 0.0, linearField());
  Scene whole(grid);
  Scene scene(grid);
  const Image expected = whole.render();
  for (const int parts : { 2, 3, 8 })
  {
    const auto input = blocks(cutIntoBlocks(grid, partsOfUnitCube(parts)));
    scene.Mapper->SetInputDataObject(input);
    const Difference difference = compare(scene.render(), expected);
    EXPECT_LE(difference.Max, 1.0 / 255.0);
    Counts counts = countsOf(scene.Mapper);
    counts.Cells = whole.Mapper->GetNumberOfCrossedCells();
    expectSameCounts(counts, countsOf(whole.Mapper));
    std::cout << "[ MEASURED ] " << parts << " blocks: " << difference.text() << "\n";
  }
}

TEST(Blocks, CollectionsOfPartsThroughAPipeline)
{
  const Grid whole = jitteredLattice(6, 0.15, 1, sineField());
  Scene scene(whole);
  const Image expected = scene.render();
  vtkNew<vtkPartitionedDataSetCollection> collection;
  vtkNew<vtkPartitionedDataSet> parts;
  const std::vector<Grid> cut = cutIntoBlocks(whole, partsOfUnitCube(8));
  for (unsigned b = 0; b < 8; ++b)
  {
    collection->SetPartition(b / 3, b % 3, cut[b]);
    parts->SetPartition(b, cut[b]);
  }
  for (vtkDataObject* input :
    { static_cast<vtkDataObject*>(collection.Get()), static_cast<vtkDataObject*>(parts.Get()) })
  {
    vtkNew<vtkTrivialProducer> source;
    source->SetOutput(input);
    scene.Mapper->SetInputConnection(source->GetOutputPort());
    EXPECT_EQ(compare(scene.render(), expected).Max, 0.0);
    EXPECT_EQ(scene.Mapper->GetDataObjectInput(), input);
  }
}

TEST(Blocks, Bounds)
{
  const Grid whole = jitteredLattice(4, 0.0);
  Scene scene(whole);
  const std::vector<Grid> cut = cutIntoBlocks(whole, partsOfUnitCube(8));
  const auto input = blocks({ cut[0], cut[3] });
  scene.Mapper->SetInputDataObject(input);
  double bounds[6];
  scene.Mapper->GetBounds(bounds);
  EXPECT_EQ(std::vector<double>(bounds, bounds + 6), (std::vector<double>{ 0, 1, 0, 1, 0, 0.5 }));
  const double* ofVolume = scene.Volume->GetBounds();
  EXPECT_TRUE(std::equal(bounds, bounds + 6, ofVolume));
  input->SetBlock(1, nullptr);
  EXPECT_EQ(scene.Mapper->GetBounds()[3], 0.5);
  input->SetBlock(0, nullptr);
  EXPECT_FALSE(vtkMath::AreBoundsInitialized(scene.Mapper->GetBounds()));
  scene.Mapper->SetInputData(whole);
  EXPECT_EQ(scene.Mapper->GetBounds()[5], 1.0);
}

TEST(Blocks, NewScalarsAreUploadedAlone)
{
  const Grid whole = jitteredLattice(8, 0.15, 1, sineField());
  const std::vector<Grid> cut = cutIntoBlocks(whole, partsOfUnitCube(8));
  const auto input = blocks(cut);
  Scene scene(whole);
  scene.Mapper->SetInputDataObject(input);
  const Image before = scene.render();
  EXPECT_EQ(scene.Mapper->GetBlocksBuilds(), 1);
  vtkTypeInt64 bytes = scene.Mapper->GetUploadedBytes();
  scene.render();
  EXPECT_EQ(scene.Mapper->GetBlocksBuilds(), 1);
  EXPECT_EQ(scene.Mapper->GetUploadedBytes(), bytes);
  // In the same blocks, and in new ones.
  vtkNew<vtkMultiBlockDataSet> copy;
  for (vtkMultiBlockDataSet* next : { input.Get(), copy.Get() })
  {
    if (next == copy)
    {
      copy->DeepCopy(input);
    }
    vtkDataArray* scalars =
      vtkUnstructuredGrid::SafeDownCast(next->GetBlock(0))->GetPointData()->GetScalars();
    scalars->SetTuple1(0, next == copy ? 0.11 : 0.9);
    scalars->Modified();
    scene.Mapper->SetInputDataObject(next);
    EXPECT_GT(compare(scene.render(), before).Max, 0.0);
    EXPECT_EQ(scene.Mapper->GetMeshBuilds(), 1);
    EXPECT_EQ(scene.Mapper->GetUploadedBytes() - bytes, 16 * whole->GetNumberOfPoints());
    bytes = scene.Mapper->GetUploadedBytes();
  }
  EXPECT_EQ(scene.Mapper->GetBlocksBuilds(), 3);
  // A block of another shape.
  vtkPoints* points = vtkUnstructuredGrid::SafeDownCast(copy->GetBlock(7))->GetPoints();
  points->GetData()->SetComponent(40, 1, points->GetPoint(40)[1] + 0.001);
  points->Modified();
  const Image changed = scene.render();
  EXPECT_EQ(scene.Mapper->GetMeshBuilds(), 2);
  Scene fresh(whole);
  fresh.Mapper->SetInputDataObject(copy);
  EXPECT_EQ(compare(changed, fresh.render()).Max, 0.0);
}

class BlockErrors : public ErrorScene
{
protected:
  void showBlocks(const std::vector<Grid>& grids)
  {
    this->Shown.Mapper->SetInputDataObject(blocks(grids));
  }
};

TEST_F(BlockErrors, AreReportedOnce)
{
  std::vector<Grid> cut = cutIntoBlocks(soundGrid(), partsOfUnitCube(2));
  for (const Grid& block : cut)
  {
    block->GetPointData()->SetActiveScalars(nullptr);
    block->GetCellData()->Initialize();
  }
  this->expectError([&] { this->showBlocks(cut); }, [this] { this->showSound(); },
    { "No block has active scalars", "Point arrays: f" });
  cut = cutIntoBlocks(soundGrid(), partsOfUnitCube(2));
  cut[1]->GetPoints()->SetPoint(7, std::nan(""), 0.0, 0.0);
  this->expectError([&] { this->showBlocks(cut); }, [this] { this->showSound(); },
    { "Block number 2", "point 7", "not a finite number" });
  vtkNew<vtkMultiBlockDataSet> others;
  vtkNew<OtherGrid> other;
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetNumberOfTuples(4);
  other->GetPointData()->SetScalars(scalars);
  others->SetBlock(0, other);
  this->expectError([&] { this->Shown.Mapper->SetInputDataObject(others); },
    [this] { this->showSound(); }, { "Block number 1", "OtherGrid", "vtkAppendFilter" });
}

TEST_F(BlockErrors, NothingToDrawIsNoError)
{
  this->showBlocks({});
  this->expectEmptyWithoutErrors();
  this->showBlocks({ nullptr, emptyGrid(), triangleAndLineGrid() });
  this->expectEmptyWithoutErrors();
  this->showBlocks(cutIntoBlocks(soundGrid(), partsOfUnitCube(2)));
  this->expectSound();
  this->showSound();
  this->expectSound();
}

TEST_F(BlockErrors, BlocksWithoutTheArrayAreNamedOnce)
{
  const std::vector<Grid> cut = cutIntoBlocks(soundGrid(), partsOfUnitCube(8));
  auto others = cut;
  others.erase(others.begin() + 5);
  this->showBlocks(others);
  const Image expected = this->frame();
  const ErrorWatch watch(this->Shown.Mapper);
  cut[5]->GetPointData()->Initialize();
  cut[5]->GetCellData()->Initialize();
  this->showBlocks(cut);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(compare(this->frame(), expected).Max, 0.0);
  }
  ASSERT_EQ(watch.Warnings.size(), 1u);
  EXPECT_NE(watch.Warnings[0].find("active scalars"), std::string::npos) << watch.Warnings[0];
  EXPECT_NE(watch.Warnings[0].find("number 6"), std::string::npos) << watch.Warnings[0];
  this->showSound();
  this->expectSound();
  EXPECT_EQ(watch.Warnings.size(), 1u);
  EXPECT_EQ(watch.Errors, std::vector<std::string>());
}
} // namespace
