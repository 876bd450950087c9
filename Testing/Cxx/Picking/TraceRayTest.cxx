// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The table of a ray, as the mapper gives it: what it refuses, its lengths in the world, its cells,
// and its pixel beside that of the GPU.
#include "ErrorWatch.h"
#include "GridBlocks.h"
#include "PickScene.h"

#include "vtkCell.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

constexpr int Float = vtkTetMarchVolumeMapper::TRACE_FLOAT;
constexpr int Double = vtkTetMarchVolumeMapper::TRACE_DOUBLE;
constexpr int GroundTruth = vtkTetMarchVolumeMapper::TRACE_GROUND_TRUTH;

double valueOf(vtkTable* table, vtkIdType row, const char* column)
{
  return table->GetValueByName(row, column).ToDouble();
}

double factOf(vtkTable* table, const char* name, int component = 0)
{
  return table->GetFieldData()->GetArray(name)->GetComponent(0, component);
}

TEST(TraceRay, RefusesWhatIsNoPixelOfAFrame)
{
  Scene scene(jitteredLattice(4));
  vtkNew<vtkTable> cells;
  ErrorWatch watch(scene.Mapper);
  EXPECT_FALSE(scene.Mapper->TraceRay(scene.Volume, 80, 80, Float, cells));
  ASSERT_EQ(watch.Errors.size(), 1u);
  EXPECT_NE(watch.Errors[0].find("render the window first"), std::string::npos) << watch.Errors[0];
  scene.render();
  EXPECT_TRUE(scene.Mapper->TraceRay(scene.Volume, 80, 80, Float, cells));
  EXPECT_GT(cells->GetNumberOfRows(), 0);
  for (const auto& pixel : { std::array{ -1, 5 }, std::array{ 5, -1 }, std::array{ SceneSize, 5 },
         std::array{ 5, SceneSize } })
  {
    EXPECT_FALSE(scene.Mapper->TraceRay(scene.Volume, pixel[0], pixel[1], Float, cells));
    EXPECT_NE(
      watch.Errors.back().find("is outside the last frame, of 160 x 160 pixels"), std::string::npos)
      << watch.Errors.back();
    EXPECT_EQ(cells->GetNumberOfRows(), 0);
  }
  EXPECT_FALSE(scene.Mapper->TraceRay(nullptr, 80, 80, Float, cells));
  EXPECT_NE(watch.Errors.back().find("no volume was given"), std::string::npos);
  EXPECT_FALSE(scene.Mapper->TraceRay(scene.Volume, 80, 80, 3, cells));
  EXPECT_EQ(watch.Errors.size(), 7u);
}

TEST(TraceRay, EndsWithThePixel)
{
  Scene scene(jitteredLattice(5));
  const Image drawn = scene.render();
  int seen = 0;
  for (int y = 4; y < SceneSize; y += 16)
  {
    for (int x = 4; x < SceneSize; x += 16)
    {
      vtkNew<vtkTable> inFloat, inDouble;
      ASSERT_TRUE(scene.Mapper->TraceRay(scene.Volume, x, y, Float, inFloat));
      ASSERT_TRUE(scene.Mapper->TraceRay(scene.Volume, x, y, Double, inDouble));
      for (int k = 0; k < 4; ++k)
      {
        EXPECT_NEAR(factOf(inFloat, "Color", k), double(drawn.pixel(x, y)[k]), 2.0 / 255.0);
        EXPECT_NEAR(factOf(inDouble, "Color", k), factOf(inFloat, "Color", k), 2.0 / 255.0);
      }
      EXPECT_LE(factOf(inDouble, "ErrorBound"), scene.Mapper->GetUsedErrorTolerance());
      EXPECT_EQ(factOf(inFloat, "RefusedEntries") + factOf(inFloat, "LostRays") +
                  factOf(inFloat, "GuardHits"),
        0.0);
      seen += inFloat->GetNumberOfRows() > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(seen, 20);
}

TEST(TraceRay, EndsWithThePixelOfTheGroundTruth)
{
  Scene scene(jitteredLattice(5));
  scene.render();
  vtkNew<vtkFloatArray> truth;
  ASSERT_TRUE(scene.Mapper->RenderGroundTruth(scene.Volume, truth));
  for (const auto& [x, y] : { std::pair{ 80, 80 }, std::pair{ 60, 100 }, std::pair{ 2, 2 } })
  {
    vtkNew<vtkTable> cells;
    ASSERT_TRUE(scene.Mapper->TraceRay(scene.Volume, x, y, GroundTruth, cells));
    for (int k = 0; k < 4; ++k)
    {
      EXPECT_EQ(float(factOf(cells, "Color", k)), truth->GetComponent(y * SceneSize + x, k));
    }
  }
}

TEST(TraceRay, CountsLengthsInTheWorldFromTheNearPlane)
{
  auto scene = evenScene(jitteredLattice(5));
  scene->Volume->SetPosition(0.02, -0.03, 0.01);
  scene->Volume->SetScale(1.1);
  scene->Window->Render();
  for (int y = 20; y < SceneSize; y += 20)
  {
    for (int x = 20; x < SceneSize; x += 20)
    {
      const PickScene::PixelLine line = scene->lineOf(x, y);
      vtkNew<vtkTable> cells;
      ASSERT_TRUE(scene->Mapper->TraceRay(scene->Volume, x, y, Double, cells));
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_NEAR(factOf(cells, "Origin", k), line.Near[k], 1e-9);
        EXPECT_NEAR(factOf(cells, "Direction", k), line.Direction[k], 1e-9);
      }
      const vtkIdType last = cells->GetNumberOfRows() - 1;
      const double chord =
        boxChord(line.Near, line.Direction, { 0.02, -0.03, 0.01 }, { 1.12, 1.07, 1.11 }, 0.0);
      const double found =
        last < 0 ? 0.0 : valueOf(cells, last, "Leave") - valueOf(cells, 0, "Enter");
      if (factOf(cells, "Opaque") == 0.0)
      {
        EXPECT_NEAR(found, chord, 2e-6);
      }
      if (last >= 0)
      {
        const double thickness = valueOf(cells, 0, "End") - valueOf(cells, 0, "Begin");
        EXPECT_NEAR(valueOf(cells, 0, "Opacity"),
          slabOpacity(Even::Opacity / Even::UnitDistance, thickness), 1e-6);
        EXPECT_NEAR(factOf(cells, "ThicknessPerLength"), 1.0 / Even::UnitDistance, 1e-9);
      }
    }
  }
}

// The cells of the input, by a search of their own: the middle of each row lies in its cell.
TEST(TraceRay, NamesTheCellsOfBlocks)
{
  const Grid grid = jitteredLattice(4);
  const std::vector<Grid> parts = cutIntoBlocks(grid, partsOfUnitCube(8));
  auto scene = evenScene(grid);
  scene->Mapper->SetInputDataObject(blocks(parts));
  scene->Window->Render();
  const PickScene::PixelLine line = scene->lineOf(70, 85);
  vtkNew<vtkTable> cells;
  ASSERT_TRUE(scene->Mapper->TraceRay(scene->Volume, 70, 85, Double, cells));
  ASSERT_GT(cells->GetNumberOfRows(), 4);
  int blocksSeen = 0, lastBlock = 0;
  for (vtkIdType row = 0; row < cells->GetNumberOfRows(); ++row)
  {
    const double begin = valueOf(cells, row, "Begin"), end = valueOf(cells, row, "End");
    const int block = static_cast<int>(valueOf(cells, row, "Block"));
    ASSERT_GE(block, 1);
    ASSERT_LE(block, 8);
    blocksSeen += block != lastBlock ? 1 : 0;
    lastBlock = block;
    if (end > begin + 1e-4)
    {
      Vec3 middle = line.at(0.5 * (begin + end));
      vtkCell* cell = parts[static_cast<std::size_t>(block) - 1]->GetCell(
        static_cast<vtkIdType>(valueOf(cells, row, "CellId")));
      int sub = 0;
      double parameters[3], distance = 0.0, weights[8];
      EXPECT_EQ(
        cell->EvaluatePosition(middle.data(), nullptr, sub, parameters, distance, weights), 1)
        << row;
    }
  }
  EXPECT_GT(blocksSeen, 1);
}
} // namespace
