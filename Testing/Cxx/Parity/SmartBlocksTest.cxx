// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// An image in blocks looks like the image: blocks are drawn one over the other, back to front.
#include "SmartBlocks.h"
#include "GridBlocks.h"

#include "vtkBoundingBox.h"
#include "vtkCell.h"
#include "vtkContourValues.h"

namespace
{
using namespace tetmarch::testing;

class SmartBlocksOf
  : public SmartBlocks
  , public testing::WithParamInterface<Cut>
{
};

// Each block is rounded when it is drawn. A ray meets at most n + m + l - 2 of n x m x l blocks.
double mostOf(const Cut& cut)
{
  std::size_t met = 0;
  for (const auto& planes : cut.Planes)
  {
    met += planes.size() - 1;
  }
  return 0.5 * static_cast<double>(met - 2) + 0.5 + 1; // 1: the tolerance, of all blocks together
}

TEST_P(SmartBlocksOf, LookLikeTheWhole)
{
  const Cut& cut = this->GetParam();
  this->Shown.Mapper->SetErrorTolerance(1.0 / 2550);
  const auto expectSame = [&](const char* view)
  {
    const Difference difference = compare(this->Shown.frame(), this->inParts(cut.Planes));
    std::printf("%s, %s: %s\n", cut.Name, view, difference.text().c_str());
    EXPECT_LE(255 * difference.Max, mostOf(cut)) << view;
  };
  for (int turn = 0; turn < 6; ++turn)
  {
    this->camera()->Azimuth(67);
    this->camera()->Elevation(turn % 2 ? 40 : -55);
    this->camera()->OrthogonalizeViewUp();
    this->Shown.Renderer->ResetCameraClippingRange();
    expectSame("from outside");
  }
  this->camera()->ParallelProjectionOn();
  this->camera()->SetParallelScale(0.8);
  expectSame("parallel");
  this->camera()->ParallelProjectionOff();
  lookFromInside(this->camera());
  expectSame("from inside");
}

TEST_P(SmartBlocksOf, OfAVolumeThatIsMoved)
{
  this->Shown.Mapper->SetErrorTolerance(1.0 / 2550);
  this->Shown.Volume->SetOrigin(0.5, 0.5, 0.5);
  this->Shown.Volume->SetOrientation(20, 110, -50);
  this->Shown.Volume->SetScale(1.2, -0.7, 0.9);
  this->Shown.Renderer->ResetCamera();
  const Difference difference =
    compare(this->Shown.frame(), this->inParts(this->GetParam().Planes));
  EXPECT_LE(255 * difference.Max, mostOf(this->GetParam()));
}

TEST_P(SmartBlocksOf, TheirIsosurfacesAreThoseOfTheWhole)
{
  this->Shown.Mapper->SetBlendModeToIsoSurface();
  this->Shown.property()->GetIsoSurfaceValues()->SetValue(0, 0.4);
  this->Shown.property()->GetIsoSurfaceValues()->SetValue(1, 0.7);
  const Difference difference =
    compare(this->Shown.frame(), this->inParts(this->GetParam().Planes));
  EXPECT_LE(difference.Over, difference.Pixels / 500) << difference.text(); // at seams
}

TEST_P(SmartBlocksOf, AreOrderedByMoreThanChance)
{
  // Drawn in the order of the tree, at least one of these views would be wrong.
  this->Shown.property()->GetScalarOpacity()->RemoveAllPoints();
  this->Shown.property()->GetScalarOpacity()->AddPoint(0, 0.9);
  const Image front = this->inParts(this->GetParam().Planes);
  EXPECT_LE(255 * compare(this->Shown.frame(), front).Max, mostOf(this->GetParam()));
  this->camera()->SetPosition(1 - this->camera()->GetPosition()[0],
    1 - this->camera()->GetPosition()[1], 1 - this->camera()->GetPosition()[2]);
  const Image back = this->inParts(this->GetParam().Planes);
  EXPECT_LE(255 * compare(this->Shown.frame(), back).Max, mostOf(this->GetParam()));
}

// The first visible point of a ray is that of the whole, and the block and its cell are around it.
TEST_P(SmartBlocksOf, PicksFindTheirCells)
{
  vtkTetMarchSmartVolumeMapper* mapper = this->Shown.Mapper;
  mapper->SetPickOpacityThreshold(0);
  const auto tree = inBlocks(this->Whole, this->GetParam().Planes);
  int hits = 0;
  for (int y = 5; y < Side; y += 12)
  {
    for (int x = 5; x < Side; x += 12)
    {
      mapper->SetInputDataObject(this->Whole);
      const bool hit = mapper->Pick(this->Shown.Renderer, this->Shown.Volume, x, y);
      EXPECT_EQ(mapper->GetPickedBlock(), 0u);
      std::array<double, 3> point{};
      mapper->GetPickedPosition(point.data());
      const double scalar = mapper->GetPickedScalar();
      mapper->SetInputDataObject(tree);
      ASSERT_EQ(mapper->Pick(this->Shown.Renderer, this->Shown.Volume, x, y), hit);
      if (!hit)
      {
        continue;
      }
      ++hits;
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_NEAR(mapper->GetPickedPosition()[k], point[k], 1e-4);
      }
      EXPECT_NEAR(mapper->GetPickedScalar(), scalar, 1e-3);
      vtkDataSet* block = blockAt(tree, mapper->GetPickedBlock());
      ASSERT_TRUE(block) << mapper->GetPickedBlock();
      ASSERT_LT(mapper->GetPickedCellId(), block->GetNumberOfCells());
      vtkBoundingBox box(block->GetCell(mapper->GetPickedCellId())->GetBounds());
      box.Inflate(1e-4);
      EXPECT_TRUE(box.ContainsPoint(point.data()));
    }
  }
  EXPECT_GT(hits, 10);
}

TEST_P(SmartBlocksOf, FiguresAreSums)
{
  vtkTetMarchSmartVolumeMapper* mapper = this->Shown.Mapper;
  this->Shown.frame();
  const vtkTypeInt64 bytes = mapper->GetGPUMemoryBytes();
  std::size_t blocks = 1;
  for (const auto& planes : this->GetParam().Planes)
  {
    blocks *= planes.size() - 1;
  }
  mapper->SetInputDataObject(inBlocks(this->Whole, this->GetParam().Planes));
  this->Shown.frame();
  EXPECT_EQ(mapper->GetNumberOfLatticeCells(), Cells * Cells * Cells);
  EXPECT_GT(mapper->GetGPUMemoryBytes(), bytes);
  const vtkTypeInt64 builds = mapper->GetMeshBuilds();
  EXPECT_EQ(builds, static_cast<vtkTypeInt64>(blocks) + 1) << "the first block had another grid";
  this->camera()->Azimuth(10);
  this->Shown.frame();
  EXPECT_EQ(mapper->GetMeshBuilds(), builds);
  EXPECT_EQ(mapper->GetNumberOfDraws(), static_cast<int>(blocks)) << "one tile each";
  // Blocks that are no more leave nothing behind.
  mapper->SetInputDataObject(this->Whole);
  this->Shown.frame();
  EXPECT_EQ(mapper->GetGPUMemoryBytes(), bytes);
}

TEST_P(SmartBlocksOf, BoundsAreThoseOfAll)
{
  std::array<double, 6> bounds{};
  this->Shown.Mapper->SetInputDataObject(inBlocks(this->Whole, this->GetParam().Planes));
  this->Shown.Mapper->GetBounds(bounds.data());
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(bounds[i], i % 2, 1e-15);
  }
}

INSTANTIATE_TEST_SUITE_P(Cut, SmartBlocksOf, testing::ValuesIn(Cuts),
  [](const auto& test) { return std::string(test.param.Name); });
} // namespace
