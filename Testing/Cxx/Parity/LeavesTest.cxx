// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Adaptive meshes and trees look like their leaves.
#include "AdaptiveMeshes.h"
#include "CutScene.h"
#include "ErrorScene.h"
#include "GridBlocks.h"
#include "LeafTrees.h"
#include "ScenePage.h"

#include "vtkBitArray.h"
#include "vtkBoundingBox.h"
#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkContourValues.h"
#include "vtkDoubleArray.h"
#include "vtkHyperTreeGrid.h"
#include "vtkHyperTreeGridToUnstructuredGrid.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOverlappingAMR.h"
#include "vtkRandomHyperTreeGridSource.h"
#include "vtkTetMarchFrameStatistics.h"

#include <iostream>
#include <random>

namespace
{
using namespace tetmarch::testing;

// An adaptive mesh: each place has the constant scalar of the finest cell there.
TEST(Leaves, OfBlocksAreTheFinestCells)
{
  for (const bool fromInside : { false, true })
  {
    SCOPED_TRACE(fromInside ? "from inside" : "from outside");
    Scene even(evenMesh(sineField()));
    Scene adaptive(even.Data);
    adaptive.Mapper->SetInputDataObject(adaptiveMesh(sineField()));
    for (Scene* scene : { &even, &adaptive })
    {
      scene->drawCellScalars();
      fromInside ? lookFromInside(scene->camera()) : void();
    }
    const Image expected = even.render();
    const Difference difference = compare(adaptive.render(), expected);
    EXPECT_LE(difference.Max, 1.0 / 255.0) << difference.text();
    EXPECT_EQ(adaptive.Mapper->GetNumberOfLostRays(), 0);
    EXPECT_LT(adaptive.Mapper->GetNumberOfCrossedCells(), even.Mapper->GetNumberOfCrossedCells());
    std::cout << "[ MEASURED ] " << difference.text() << "\n";
  }
}

// Trees in the unit cube, some of their leaves masked. Cell scalars "c" at random.
vtkSmartPointer<vtkHyperTreeGrid> randomTrees()
{
  vtkNew<vtkRandomHyperTreeGridSource> source;
  source->SetDimensions(4, 4, 4);
  source->SetOutputBounds(0, 1, 0, 1, 0, 1);
  source->SetMaxDepth(3);
  source->SetSeed(5);
  source->Update();
  const vtkSmartPointer<vtkHyperTreeGrid> trees = source->GetHyperTreeGridOutput();
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("c");
  vtkNew<vtkBitArray> mask;
  std::mt19937 random(1);
  for (vtkIdType node = 0; node <= trees->GetGlobalNodeIndexMax(); ++node)
  {
    scalars->InsertNextValue(double(random() % 1000) / 1000.0);
    mask->InsertNextValue(random() % 10 == 0 ? 1 : 0);
  }
  trees->SetMask(mask);
  trees->GetCellData()->Initialize();
  trees->GetCellData()->SetScalars(scalars);
  return trees;
}

Grid leavesOf(vtkHyperTreeGrid* trees)
{
  vtkNew<vtkHyperTreeGridToUnstructuredGrid> leaves;
  leaves->SetInputDataObject(trees);
  leaves->Update();
  return vtkUnstructuredGrid::SafeDownCast(leaves->GetOutputDataObject(0));
}

// Alone or as a block, before and after a change of values.
TEST(Leaves, OfTreesAreTheirCells)
{
  const auto trees = randomTrees();
  vtkNew<vtkMultiBlockDataSet> inBlocks;
  inBlocks->SetBlock(2, trees);
  for (vtkDataObject* input : std::initializer_list<vtkDataObject*>{ trees, inBlocks })
  {
    SCOPED_TRACE(input->GetClassName());
    const Grid grid = leavesOf(trees);
    Scene scene(grid);
    scene.Mapper->SetInputDataObject(input);
    for (int round = 0; round < 2; ++round)
    {
      Scene leaves(leavesOf(trees));
      leaves.drawCellScalars();
      scene.drawCellScalars();
      EXPECT_LE(compare(scene.render(), leaves.render()).Max, input == trees ? 1.0 / 255.0 : 0.0);
      EXPECT_EQ(scene.Mapper->GetNumberOfLatticeCells(),
        input == trees ? grid->GetNumberOfCells() : 0); // in blocks they are tetrahedra
      EXPECT_EQ(scene.Mapper->GetBlocksBuilds(), round + 1);
      EXPECT_EQ(vtkBoundingBox(scene.Mapper->GetBounds()), vtkBoundingBox(grid->GetBounds()));
      vtkDataArray* scalars = trees->GetCellData()->GetScalars();
      for (vtkIdType node = 0; node < scalars->GetNumberOfTuples(); ++node)
      {
        scalars->SetComponent(node, 0, 1.0 - scalars->GetComponent(node, 0));
      }
      scalars->Modified();
    }
    EXPECT_EQ(scene.Mapper->GetNumberOfLostRays(), 0);
  }
}

// Leaves of four levels, some of them masked.
LeafTrees wavyTrees()
{
  return leafTrees(
    3, sineField(2.1),
    [](const Node& node)
    { return node.Level < 3 && node.Low[0] + node.Low[2] < 0.9 - 0.2 * node.Level; },
    [](const Node& node)
    { return noiseField(5, 64)(node.Low[0], node.Low[1], node.Low[2]) < 0.1; });
}

struct Case
{
  const char* Name;
  std::function<void(Scene&)> Set;
};

const Case Unlit[] = {
  { "volume", [](Scene&) {} },
  { "from inside", [](Scene& scene) { lookFromInside(scene.camera()); } },
  { "maximum", [](Scene& scene) { scene.Mapper->SetBlendModeToMaximumIntensity(); } },
  { "average", [](Scene& scene) { scene.Mapper->SetBlendModeToAverageIntensity(); } },
  { "clipped", [](Scene& scene) { clipObliquely(scene); } },
  { "cropped", [](Scene& scene) { crop(scene, VTK_CROP_FENCE); } },
  { "mostly transparent", [](Scene& scene) { setSpikyFunctions(scene.property()); } },
};

// Where levels differ, hexahedra have no surface between them, but leaves do.
const Case OfEqualLeaves[] = {
  { "isosurfaces",
    [](Scene& scene)
    {
      scene.Mapper->SetBlendModeToIsoSurface();
      scene.property()->GetIsoSurfaceValues()->SetValue(0, 0.5);
    } },
};

void expectLikeHexahedra(const LeafTrees& made, const Case& c)
{
  SCOPED_TRACE(c.Name);
  Scene stored(made.Leaves);
  Scene leaves(made.Leaves);
  leaves.Mapper->SetInputDataObject(made.Trees);
  for (Scene* scene : { &stored, &leaves })
  {
    scene->drawCellScalars();
    c.Set(*scene);
  }
  const Image expected = stored.render();
  const Difference difference = compare(leaves.render(), expected);
  EXPECT_LE(difference.Rms, 0.1 / 255.0);
  EXPECT_LE(difference.Max, 1.0 / 255.0) << difference.text();
  EXPECT_EQ(leaves.Mapper->GetNumberOfLatticeCells(), made.Leaves->GetNumberOfCells());
  EXPECT_EQ(leaves.Mapper->GetNumberOfTetrahedra(), 0);
  EXPECT_EQ(leaves.Mapper->GetNumberOfGuardHits(), 0);
  std::cout << "[ MEASURED ] " << c.Name << ": " << difference.text() << "\n";
}

TEST(Leaves, LookLikeHexahedra)
{
  const LeafTrees wavy = wavyTrees();
  for (const Case& c : Unlit)
  {
    expectLikeHexahedra(wavy, c);
  }
  const LeafTrees even = leafTrees(8, sineField(2.1), [](const Node&) { return false; });
  for (const Case& c : OfEqualLeaves)
  {
    expectLikeHexahedra(even, c);
  }
}

// Shadows are softer than the truth: sampled along rays, and more so at nodes.
TEST(Leaves, LightIsThatOfTheGroundTruth)
{
  const LeafTrees made = wavyTrees();
  const std::pair<Case, double> cases[] = {
    { { "light", [](Scene&) {} }, 0.01 },
    { { "gradient opacity", [](Scene& scene) { setGradientOpacity(scene.property()); } }, 0.01 },
    { { "shadows along rays", [](Scene& scene) { scene.Mapper->SetShadowMethodToAlongRays(); } },
      0.03 },
    { { "shadows at vertices", [](Scene& scene) { scene.Mapper->SetShadowMethodToAtVertices(); } },
      0.06 },
  };
  for (const auto& [c, most] : cases)
  {
    SCOPED_TRACE(c.Name);
    LitScene scene(made.Leaves, 64, 64);
    scene.Mapper->SetInputDataObject(made.Trees);
    scene.drawCellScalars();
    c.Set(scene);
    scene.render();
    c.Name == std::string("light") ? keepScenePage(scene.Window) : void();
    ASSERT_TRUE(scene.Mapper->CompareWithGroundTruth(scene.Volume));
    vtkTetMarchFrameStatistics* statistics = scene.Mapper->GetLastFrameStatistics();
    const int trueError = vtkTetMarchFrameStatistics::TRUE_ERROR;
    EXPECT_GT(statistics->GetNumberOfPixels(trueError), 500);
    EXPECT_LE(statistics->GetPercentile(trueError, 99.0), most);
    std::cout << "[ MEASURED ] " << c.Name << ": " << statistics->GetPercentile(trueError, 99.0)
              << "\n";
  }
}

// Rays along a thousand leaves, up to twelve levels deep: each takes a descent to the leaf and,
// where it is lit, to its neighbours. llvmpipe would end rays that take too many turns of loops for
// it.
TEST(Leaves, OfDeepTreesAreLitToTheEnd)
{
  const double x = 0.501;
  const auto isOnLine = [x](const Node& node)
  {
    return node.Level < 11 && node.Low[0] <= x && x < node.Low[0] + node.Width &&
           node.Low[1] <= x && x < node.Low[1] + node.Width;
  };
  const LeafTrees made = leafTrees(1, sineField(2.1), isOnLine);
  Scene scene(made.Leaves, 16, 16);
  scene.Mapper->SetInputDataObject(made.Trees);
  scene.drawCellScalars();
  lookDownZ(scene.camera(), 0.0004);
  scene.camera()->SetFocalPoint(x, x, 0.5);
  scene.camera()->SetPosition(x, x, 3.0);
  scene.Renderer->ResetCameraClippingRange();
  scene.property()->SetScalarOpacityUnitDistance(2.0);
  const Image expected = scene.render();
  EXPECT_GT(scene.Mapper->GetNumberOfCrossedCells(), 16 * 16 * 1000);
  scene.property()->ShadeOn();
  const Image drawn = scene.render();
  for (std::size_t pixel = 0; pixel < drawn.Rgba.size(); pixel += 4)
  {
    ASSERT_NEAR(drawn.Rgba[pixel + 3], expected.Rgba[pixel + 3], 1e-5) << "pixel " << pixel / 4;
  }
}

// Of blocks the cell of the block; of a tree the number of the leaf.
TEST(Leaves, ArePicked)
{
  const LeafTrees made = wavyTrees();
  const auto blocks = adaptiveMesh(sineField());
  for (vtkDataObject* input : std::initializer_list<vtkDataObject*>{ made.Trees, blocks })
  {
    SCOPED_TRACE(input->GetClassName());
    Scene scene(made.Leaves, 64, 64);
    scene.Mapper->SetInputDataObject(input);
    scene.drawCellScalars();
    scene.render();
    int hits = 0;
    for (int pixel = 0; pixel < 64 * 64; pixel += 97)
    {
      vtkTetMarchVolumeMapper* mapper = scene.Mapper;
      if (!mapper->Pick(scene.Renderer, scene.Volume, pixel % 64, pixel / 64))
      {
        continue;
      }
      ++hits;
      vtkDataSet* picked =
        input == blocks ? blockAt(blocks, mapper->GetPickedBlock()) : made.Leaves.Get();
      ASSERT_TRUE(picked);
      const vtkIdType cell = mapper->GetPickedCellId();
      ASSERT_LT(cell, picked->GetNumberOfCells());
      EXPECT_NEAR(picked->GetCellData()->GetScalars()->GetComponent(cell, 0),
        mapper->GetPickedScalar(), 1e-5);
      vtkBoundingBox box(picked->GetCell(cell)->GetBounds());
      box.Inflate(1e-4);
      EXPECT_TRUE(box.ContainsPoint(mapper->GetPickedPosition()));
    }
    EXPECT_GT(hits, 5);
  }
}

// An input of leaves may follow one of tetrahedra, or precede it. Memory of the other is freed.
TEST(Leaves, ComeAndGo)
{
  const LeafTrees made = wavyTrees();
  Scene scene(made.Leaves);
  scene.drawCellScalars();
  const Image expected = scene.render();
  const auto expectMemory = [&](vtkDataObject* input)
  {
    scene.Mapper->SetInputDataObject(input);
    EXPECT_LE(compare(scene.render(), expected).Max, 1.0 / 255.0);
    return scene.Mapper->GetGPUMemoryBytes();
  };
  const auto ofTetrahedra = expectMemory(made.Leaves);
  const auto ofLeaves = expectMemory(made.Trees);
  EXPECT_NE(ofLeaves, ofTetrahedra);
  EXPECT_EQ(expectMemory(made.Leaves), ofTetrahedra);
  scene.Window->ReleaseGraphicsResources(scene.Window);
  EXPECT_EQ(expectMemory(made.Trees), ofLeaves);
}

using LeafErrors = ErrorScene;

TEST_F(LeafErrors, OfTreesThatLackValues)
{
  const auto trees = randomTrees();
  const std::pair<vtkDataArray*, Words> cases[] = {
    { trees->GetYCoordinates(), { "4 points along axis 1", "coordinates" } },
    { trees->GetMask(), { "mask has 2 values", "cells" } },
    { trees->GetCellData()->GetScalars(), { "\"c\" has 2 tuples", "cells" } },
  };
  for (const auto& [array, words] : cases)
  {
    const vtkIdType count = array->GetNumberOfTuples();
    array->SetNumberOfTuples(2);
    trees->Modified();
    this->expectError([&] { this->show(trees); }, [this] { this->showSound(); }, words);
    array->SetNumberOfTuples(count);
  }
}
} // namespace
