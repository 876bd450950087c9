// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Adaptive meshes and trees look like their leaves.
#include "AdaptiveMeshes.h"
#include "ErrorScene.h"

#include "vtkBitArray.h"
#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkHyperTreeGrid.h"
#include "vtkHyperTreeGridToUnstructuredGrid.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOverlappingAMR.h"
#include "vtkRandomHyperTreeGridSource.h"

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
      EXPECT_EQ(compare(scene.render(), leaves.render()).Max, 0.0);
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
