// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Octrees: each place has the leaf that was put there, and gradients across levels are those of
// linear functions.
#include "Structured/Octree.h"

#include "Leaves/LeafGrid.h"
#include "Reference/LitConstantKernel.h"
#include "Volume/StructuredVolume.h"

#include "AdaptiveMeshes.h"
#include "GridBlocks.h"
#include "LeafTrees.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkHyperTreeGrid.h"
#include "vtkImageData.h"
#include "vtkOverlappingAMR.h"
#include "vtkUniformGrid.h"

#include <gtest/gtest.h>
#include <random>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

using Kernel = LitConstantKernel<double>;

// Boxes at random, halved from roots; some places have none.
std::vector<OctreeBox> randomBoxes(const OctreeBox& box, std::mt19937& random)
{
  if (random() % 10 == 0)
  {
    return {};
  }
  if (box.Width == 1 || random() % 3 == 0)
  {
    return { box };
  }
  std::vector<OctreeBox> boxes;
  for (int child = 0; child < 8; ++child)
  {
    OctreeBox part{ box.Low, box.Width / 2 };
    for (int a = 0; a < 3; ++a)
    {
      part.Low[a] += (child >> a & 1) * part.Width;
    }
    const std::vector<OctreeBox> parts = randomBoxes(part, random);
    boxes.insert(boxes.end(), parts.begin(), parts.end());
  }
  return boxes;
}

// Whatever the size of the table.
TEST(Octree, FindsTheLeafOfEachPlace)
{
  constexpr int width = 8;
  const std::array<int, 3> places{ { 3 * width, width, 2 * width } };
  std::mt19937 random(1);
  std::vector<OctreeBox> boxes;
  for (int root = 0; root < 6; ++root)
  {
    const auto parts =
      randomBoxes({ { { root % 3 * width, 0, root / 3 * width } }, width }, random);
    boxes.insert(boxes.end(), parts.begin(), parts.end());
  }
  const auto outside = static_cast<std::uint32_t>(boxes.size());
  std::vector<std::uint32_t> numbers(std::size_t(places[0]) * places[1] * places[2], outside);
  const auto indexOf = [&](int i, int j, int k) { return i + places[0] * (j + places[1] * k); };
  for (std::size_t b = 0; b < boxes.size(); ++b)
  {
    for (int p = 0; p < boxes[b].Width * boxes[b].Width * boxes[b].Width; ++p)
    {
      const int w = boxes[b].Width;
      const std::array<int, 3>& low = boxes[b].Low;
      numbers[indexOf(low[0] + p % w, low[1] + p / w % w, low[2] + p / w / w)] =
        static_cast<std::uint32_t>(b);
    }
  }
  for (const std::size_t leaves : { std::size_t(1), boxes.size(), numbers.size() })
  {
    SCOPED_TRACE(leaves);
    OctreeBuilder builder(places, leaves, outside);
    for (std::size_t b = 0; b < boxes.size(); ++b)
    {
      ASSERT_TRUE(builder.add(boxes[b], static_cast<std::uint32_t>(b)));
    }
    const Octree tree = builder.take();
    EXPECT_LE(tree.Nodes.size(), 6 + 2 * numbers.size());
    Kernel kernel;
    kernel.useOctree(&tree);
    for (int p = 0; p < static_cast<int>(numbers.size()); ++p)
    {
      const Kernel::ivec3 cell(p % places[0], p / places[0] % places[1], p / places[0] / places[1]);
      const auto leaf = kernel.leafAround(cell);
      ASSERT_EQ(leaf.number, numbers[p]);
      ASSERT_TRUE(leaf.low.x <= cell.x && cell.x < leaf.low.x + leaf.width);
      if (leaf.number != outside)
      {
        ASSERT_EQ(leaf.width, boxes[leaf.number].Width);
        ASSERT_EQ(leaf.low.z, boxes[leaf.number].Low[2]);
      }
    }
  }
}

TEST(Octree, RefusesWhatIsNone)
{
  OctreeBuilder builder({ { 32, 32, 32 } }, 64, 100);
  ASSERT_TRUE(builder.add({ { { 8, 0, 0 } }, 4 }, 0));
  ASSERT_TRUE(builder.add({ { { 16, 0, 0 } }, 16 }, 1));
  const OctreeBox bad[] = {
    { { { 0, 0, 0 } }, 3 },  // no power of 2
    { { { 2, 0, 0 } }, 4 },  // between places of its width
    { { { 8, 0, 0 } }, 4 },  // taken
    { { { 8, 0, 0 } }, 8 },  // has a leaf
    { { { 10, 2, 0 } }, 1 }, // in a leaf
    { { { 24, 8, 0 } }, 8 }, // in a leaf wider than the table's nodes
  };
  for (const OctreeBox& box : bad)
  {
    EXPECT_FALSE(builder.add(box, 2)) << box.Low[0] << " " << box.Width;
  }
  EXPECT_FALSE(builder.add({ { { 0, 0, 16 } }, 1 }, 1u << OctreeNumberBits));
}

bool divides(const Node& node) { return node.Level < 2 && node.Low[0] + node.Low[1] < 0.6; }

// A function of one coordinate has its exact gradient there, whatever the levels.
TEST(Octree, GradientsAreExactAcrossLevels)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const LeafTrees made = leafTrees(
      3, [axis](double x, double y, double z) { return axis == 0   ? x
                                                       : axis == 1 ? y
                                                                   : z; },
      divides);
    LeafGrid leaves;
    ASSERT_TRUE(leaves.update(made.Trees, { 0, 0, 0, nullptr }));
    StructuredVolume volume;
    const VolumeInput input{ leaves.values(), {}, Interpolation::Nearest, leaves.places() };
    const DrawnScalars drawn{ leaves.scalars(), true };
    ASSERT_EQ(volume.updateGeometry(input, {}, {}), "");
    ASSERT_EQ(volume.updateScalars(input, drawn), "");
    Kernel kernel;
    kernel.useLattice(volume.lattice(), volume.values().front());
    kernel.useOctree(volume.octree());
    const int places = volume.lattice().Axes[0].Cells; // on each axis
    std::mt19937 random(3);
    int tested = 0;
    for (int n = 0; n < 500; ++n)
    {
      std::array<int, 3> at{};
      std::generate(at.begin(), at.end(), [&] { return static_cast<int>(random() % places); });
      const Kernel::ivec3 cell(at[0], at[1], at[2]);
      const auto leaf = kernel.leafAround(cell);
      const std::array<int, 3> low{ { leaf.low.x, leaf.low.y, leaf.low.z } };
      if (low[axis] == 0 || low[axis] + leaf.width == places)
      {
        continue; // the end of the axis
      }
      const auto gradient = kernel.latticeGradientOf(0, cell, {});
      const std::array<double, 3> along{ { gradient.x, gradient.y, gradient.z } };
      // The stored scalar is 0..1 over its range.
      EXPECT_NEAR(along[axis], 1.0 / places / volume.range().width(), 1e-6);
      ++tested;
    }
    EXPECT_GT(tested, 100);
  }
}

// Of blocks and trees.
TEST(LeafGrids, HaveTheValuesOfTheirInput)
{
  const LeafTrees made = leafTrees(
    3, sineField(), divides, [](const Node& node) { return node.Level == 1 && node.Low[2] > 0.6; });
  LeafGrid leaves;
  ASSERT_TRUE(leaves.update(made.Trees, { 0, 0, 0, nullptr }));
  const auto places = leaves.places();
  vtkDataArray* expected = made.Leaves->GetCellData()->GetScalars();
  ASSERT_EQ(places->Count, static_cast<std::size_t>(expected->GetNumberOfTuples()));
  EXPECT_FALSE(places->Fill);
  for (vtkIdType leaf = 0; leaf < expected->GetNumberOfTuples(); ++leaf)
  {
    ASSERT_EQ(leaves.scalars()->GetComponent(leaf, 0), expected->GetComponent(leaf, 0));
  }
  // New values leave the places.
  vtkDataArray* scalars = made.Trees->GetCellData()->GetScalars();
  scalars->SetComponent(0, 0, 7.0);
  scalars->Modified();
  ASSERT_TRUE(leaves.update(made.Trees, { 0, 0, 0, nullptr }));
  EXPECT_EQ(leaves.places(), places);
  ASSERT_TRUE(leaves.update(made.Trees, { 0, 0, 0, nullptr }));
  EXPECT_EQ(leaves.record().Runs, 2);

  const auto blocks = adaptiveMesh(sineField());
  ASSERT_TRUE(leaves.update(blocks, { 0, 0, 0, nullptr }));
  EXPECT_TRUE(leaves.places()->Fill);
  EXPECT_EQ(leaves.places()->Count, 51u + 84u + 160u);
  for (vtkIdType leaf = 0; leaf < 295; ++leaf)
  {
    const CellOrigin origin = leaves.origins().of(leaf);
    vtkDataSet* block = blockAt(blocks, origin.Block);
    ASSERT_EQ(leaves.scalars()->GetComponent(leaf, 0),
      block->GetCellData()->GetScalars()->GetComponent(origin.Cell, 0));
  }
}

TEST(LeafGrids, AreMadeOfOctreesAlone)
{
  LeafGrid leaves;
  const auto expectNone = [&](vtkDataObject* input, const char* what)
  {
    EXPECT_FALSE(leaves.update(input, { 0, 0, 0, nullptr })) << what;
    EXPECT_FALSE(leaves.places() || leaves.values()) << what;
  };
  expectNone(nullptr, "nothing");
  const LeafTrees made = leafTrees(2, sineField(), divides);
  expectNone(made.Leaves, "hexahedra");
  ASSERT_TRUE(leaves.update(made.Trees, { 0, 0, 0, nullptr }));
  made.Trees->GetCellData()->GetScalars()->SetNumberOfTuples(2);
  made.Trees->Modified();
  expectNone(made.Trees, "a short array");
  made.Trees->GetCellData()->Initialize();
  expectNone(made.Trees, "no array");
  const auto spoiled = [](const std::function<void(vtkUniformGrid*)>& spoil)
  {
    auto blocks = adaptiveMesh(sineField());
    spoil(vtkUniformGrid::SafeDownCast(blockAt(blocks, 1)));
    return blocks;
  };
  expectNone(spoiled(
               [](vtkUniformGrid* block)
               {
                 vtkNew<vtkFloatArray> other;
                 other->DeepCopy(block->GetCellData()->GetScalars());
                 block->GetCellData()->SetScalars(other);
               }),
    "blocks of two types of values");
  expectNone(spoiled([](vtkUniformGrid* block) { block->GetCellData()->Initialize(); }),
    "a block without values");
  expectNone(spoiled([](vtkUniformGrid* block) { block->SetSpacing(0.1, 0.1, 0.1); }),
    "cells between the finest ones");
}
} // namespace
