// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// An image in blocks looks like the image: blocks are drawn one over the other, back to front.
#include "ErrorWatch.h"
#include "SmartScene.h"

#include "vtkBoundingBox.h"
#include "vtkCell.h"
#include "vtkCompositeDataIterator.h"
#include "vtkContourValues.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;
using Extent = std::array<int, 6>;

constexpr int Cells = 12; // along each edge
constexpr int Side = 96;

vtkSmartPointer<vtkImageData> whole() { return imageOf(sineField(), unitCube(Cells)); }

// The part of the image within an extent, with its points on the borders.
vtkSmartPointer<vtkImageData> partOf(vtkImageData* image, const Extent& extent)
{
  auto part = vtkSmartPointer<vtkImageData>::New();
  part->SetOrigin(image->GetOrigin());
  part->SetSpacing(image->GetSpacing());
  part->SetExtent(const_cast<int*>(extent.data()));
  vtkNew<vtkDoubleArray> values;
  values->SetName("f");
  vtkDataArray* all = image->GetPointData()->GetArray("f");
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        int ijk[3] = { i, j, k };
        values->InsertNextValue(all->GetComponent(image->ComputePointId(ijk), 0));
      }
    }
  }
  part->GetPointData()->SetScalars(values);
  return part;
}

// Parts between planes across each axis, all but one in a tree of their own.
vtkSmartPointer<vtkMultiBlockDataSet> inBlocks(
  vtkImageData* image, const std::array<std::vector<int>, 3>& planes)
{
  auto tree = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  vtkNew<vtkMultiBlockDataSet> others;
  tree->SetBlock(0, others);
  unsigned int count = 0;
  for (std::size_t k = 0; k + 1 < planes[2].size(); ++k)
  {
    for (std::size_t j = 0; j + 1 < planes[1].size(); ++j)
    {
      for (std::size_t i = 0; i + 1 < planes[0].size(); ++i)
      {
        const auto part = partOf(image, { { planes[0][i], planes[0][i + 1], planes[1][j],
                                          planes[1][j + 1], planes[2][k], planes[2][k + 1] } });
        count == 0 ? tree->SetBlock(1, part) : others->SetBlock(count, part);
        ++count;
      }
    }
  }
  return tree;
}

struct Cut
{
  const char* Name;
  std::array<std::vector<int>, 3> Planes;
};
const Cut cuts[] = {
  { "Halves", { { { 0, 7, Cells }, { 0, Cells }, { 0, Cells } } } },
  { "Eighths", { { { 0, 5, Cells }, { 0, 8, Cells }, { 0, 3, Cells } } } },
  { "ThirtySix", { { { 0, 1, 6, Cells }, { 0, 4, 10, Cells }, { 0, 3, 6, 9, Cells } } } },
};

class SmartBlocks : public testing::Test
{
protected:
  Image inParts(const std::array<std::vector<int>, 3>& planes)
  {
    this->Shown.Mapper->SetInputDataObject(inBlocks(this->Image0, planes));
    const Image parts = this->Shown.frame();
    this->Shown.Mapper->SetInputDataObject(this->Image0);
    return parts;
  }
  vtkCamera* camera() { return this->Shown.Renderer->GetActiveCamera(); }

  vtkSmartPointer<vtkImageData> Image0 = whole();
  SmartScene Shown{ Image0, Side, Side };
};

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

vtkImageData* blockOf(vtkMultiBlockDataSet* tree, unsigned int flat)
{
  const auto at = vtk::TakeSmartPointer(tree->NewIterator());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    if (at->GetCurrentFlatIndex() == flat)
    {
      return vtkImageData::SafeDownCast(at->GetCurrentDataObject());
    }
  }
  return nullptr;
}

// The first visible point of a ray is that of the whole, and the block and its cell are around it.
TEST_P(SmartBlocksOf, PicksFindTheirCells)
{
  vtkTetMarchSmartVolumeMapper* mapper = this->Shown.Mapper;
  mapper->SetPickOpacityThreshold(0);
  const auto tree = inBlocks(this->Image0, this->GetParam().Planes);
  int hits = 0;
  for (int y = 5; y < Side; y += 12)
  {
    for (int x = 5; x < Side; x += 12)
    {
      mapper->SetInputDataObject(this->Image0);
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
      vtkImageData* block = blockOf(tree, mapper->GetPickedBlock());
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
  mapper->SetInputDataObject(inBlocks(this->Image0, this->GetParam().Planes));
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
  mapper->SetInputDataObject(this->Image0);
  this->Shown.frame();
  EXPECT_EQ(mapper->GetGPUMemoryBytes(), bytes);
}

TEST_P(SmartBlocksOf, BoundsAreThoseOfAll)
{
  std::array<double, 6> bounds{};
  this->Shown.Mapper->SetInputDataObject(inBlocks(this->Image0, this->GetParam().Planes));
  this->Shown.Mapper->GetBounds(bounds.data());
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(bounds[i], i % 2, 1e-15);
  }
}

INSTANTIATE_TEST_SUITE_P(Cut, SmartBlocksOf, testing::ValuesIn(cuts),
  [](const auto& test) { return std::string(test.param.Name); });

// What goes through the whole volume can't be drawn block by block.
TEST_F(SmartBlocks, OtherBlendModesAreErrors)
{
  vtkTetMarchSmartVolumeMapper* mapper = this->Shown.Mapper;
  mapper->SetInputDataObject(inBlocks(this->Image0, cuts[0].Planes));
  const Image sound = this->Shown.frame();
  ErrorWatch watch(mapper);
  mapper->SetBlendModeToMaximumIntensity();
  this->Shown.frame();
  ASSERT_EQ(watch.Errors.size(), 1u);
  EXPECT_NE(watch.Errors[0].find("blend mode"), std::string::npos) << watch.Errors[0];
  mapper->SetBlendModeToComposite();
  EXPECT_EQ(compare(this->Shown.frame(), sound).Max, 0.0);
  EXPECT_EQ(watch.Errors.size(), 1u);
}

TEST_F(SmartBlocks, HaveNoDiagnostics)
{
  vtkTetMarchSmartVolumeMapper* mapper = this->Shown.Mapper;
  mapper->SetInputDataObject(inBlocks(this->Image0, cuts[0].Planes));
  const Image picture = this->Shown.frame();
  mapper->CollectDiagnosticsOn();
  mapper->SetViewModeToErrorBound();
  EXPECT_EQ(compare(this->Shown.frame(), picture).Max, 0.0);
  EXPECT_EQ(mapper->GetNumberOfRays(), 0);
  const ErrorWatch watch(mapper);
  EXPECT_FALSE(mapper->TraceRay(
    this->Shown.Volume, 48, 48, vtkTetMarchSmartVolumeMapper::TRACE_FLOAT, vtkNew<vtkTable>()));
  EXPECT_FALSE(mapper->RenderGroundTruth(this->Shown.Volume, vtkNew<vtkFloatArray>()));
  EXPECT_EQ(watch.Errors.size(), 2u);
}

// A tree with one block is drawn as the block.
TEST_F(SmartBlocks, OneHasAllOfIt)
{
  const Image alone = this->Shown.floats();
  vtkNew<vtkMultiBlockDataSet> tree;
  tree->SetBlock(3, this->Image0);
  this->Shown.Mapper->SetInputDataObject(tree);
  EXPECT_EQ(compare(this->Shown.floats(), alone).Max, 0.0);
  this->Shown.Mapper->SetBlendModeToMaximumIntensity();
  const ErrorWatch watch(this->Shown.Mapper);
  this->Shown.frame();
  EXPECT_EQ(watch.Errors, std::vector<std::string>());
  EXPECT_TRUE(this->Shown.Mapper->Pick(this->Shown.Renderer, this->Shown.Volume, 48, 48));
  EXPECT_EQ(this->Shown.Mapper->GetPickedBlock(), 4u);
}

TEST_F(SmartBlocks, ThoseWithoutTheArrayAreNamed)
{
  const auto tree = inBlocks(this->Image0, cuts[0].Planes);
  vtkNew<vtkImageData> bare;
  bare->CopyStructure(this->Image0);
  tree->SetBlock(2, bare);
  tree->GetMetaData(2u)->Set(vtkCompositeDataSet::NAME(), "bare one");
  this->Shown.Mapper->SetInputDataObject(inBlocks(this->Image0, cuts[0].Planes));
  const Image sound = this->Shown.frame();
  const ErrorWatch watch(this->Shown.Mapper);
  this->Shown.Mapper->SetInputDataObject(tree);
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_EQ(compare(this->Shown.frame(), sound).Max, 0.0);
    ASSERT_EQ(watch.Warnings.size(), 1u);
  }
  EXPECT_NE(watch.Warnings[0].find("bare one"), std::string::npos) << watch.Warnings[0];
  EXPECT_EQ(watch.Errors, std::vector<std::string>());
}
} // namespace
