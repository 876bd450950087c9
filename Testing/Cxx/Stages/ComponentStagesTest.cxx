// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a change of components, of their functions and weights makes anew, and what is freed with
// them.
#include "vtkTetMarchFrameStatistics.h"

#include "ComponentScene.h"
#include "ErrorWatch.h"
#include "Held.h"

#include "vtkDataArray.h"
#include "vtkMultiBlockDataSet.h"

#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;
using Mapper = vtkTetMarchVolumeMapper;

constexpr int Side = 64;

Grid lattice() { return jitteredLattice(6, 0.15, 1, sineField()); }

struct Made
{
  explicit Made(const Mapper* mapper)
    : Mesh(mapper->GetMeshBuilds())
    , Scalars(mapper->GetScalarsBuilds())
    , Tables(mapper->GetTablesBuilds())
    , Bytes(mapper->GetUploadedBytes())
  {
  }
  vtkTypeInt64 Mesh, Scalars, Tables, Bytes;
};

TEST(ComponentStages, BuffersAreThereAsLongAsTheyAreNeeded)
{
  ComponentScene scene(lattice(), { "", 4, true }, Side, Side);
  scene.Mapper->SetVectorModeToDisabled();
  const Image single = scene.render();
  const Held plain(scene);
  const auto vertices = scene.Data->GetNumberOfPoints();
  for (int round = 0; round < 2; ++round)
  {
    scene.Mapper->SetVectorModeToAllComponents();
    EXPECT_GT(compare(scene.render(), single).Max, 0.05);
    EXPECT_GT(Held(scene).Bytes, plain.Bytes + 16 * vertices);
    scene.property()->IndependentComponentsOff();
    EXPECT_GT(compare(scene.render(), single).Max, 0.05);
    EXPECT_GT(Held(scene).Bytes, plain.Bytes + 16 * vertices);
    scene.property()->IndependentComponentsOn();
    scene.Mapper->SetVectorModeToDisabled();
    EXPECT_EQ(scene.render().Rgba, single.Rgba);
    EXPECT_TRUE(Held(scene) == plain) << round;
  }
  EXPECT_EQ(scene.Mapper->GetMeshBuilds(), 1);
}

TEST(ComponentStages, AWeightIsANumber)
{
  ComponentScene scene(lattice(), { "", 3, true }, Side, Side);
  const Image before = scene.render();
  const Made first(scene.Mapper);
  scene.property()->SetComponentWeight(1, 0.1);
  EXPECT_GT(compare(scene.render(), before).Max, 0.02);
  scene.property()->SetScalarOpacityUnitDistance(2, 0.1);
  scene.render();
  const Made second(scene.Mapper);
  EXPECT_EQ(second.Tables, first.Tables);
  EXPECT_EQ(second.Bytes, first.Bytes);
  // A transfer function is part of the tables.
  scene.property()->GetScalarOpacity(2)->AddPoint(0.3, 1.0);
  scene.render();
  EXPECT_EQ(Made(scene.Mapper).Tables, first.Tables + 1);
  EXPECT_EQ(Made(scene.Mapper).Scalars, first.Scalars);
}

TEST(ComponentStages, OtherValuesUploadScalarsAlone)
{
  for (const Mix& mix : Mixes)
  {
    const Grid grid = lattice();
    ComponentScene scene(grid, mix, Side, Side);
    const Image before = scene.render();
    const Made first(scene.Mapper);
    vtkDataArray* array = grid->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      // The range stays, and with it the tables.
      const int k = mix.Components - 1;
      array->SetComponent(i, k, array->GetComponent(i, k) > 0.5 ? 1.0 : 0.0);
    }
    array->Modified();
    EXPECT_GT(compare(scene.render(), before).Max, 0.02) << mix.Name;
    const Made second(scene.Mapper);
    EXPECT_EQ(second.Mesh, 1);
    EXPECT_EQ(second.Scalars, first.Scalars + 1);
    const vtkTypeInt64 extra = mix.Components == 4 ? 16 : 4 * (mix.Components - 1);
    const vtkTypeInt64 scalars = (16 + extra) * grid->GetNumberOfPoints();
    EXPECT_GE(second.Bytes - first.Bytes, scalars) << mix.Name;
    EXPECT_LE(second.Bytes - first.Bytes, scalars + 40 * 4 * 65536) << mix.Name; // and new tables
    scene.render();
    EXPECT_EQ(Made(scene.Mapper).Bytes, second.Bytes);
  }
}

// Components without weight are not drawn, so that the other one looks as it does alone.
TEST(ComponentStages, OneOfSeveralIsWhatItIsAlone)
{
  for (const int alone : { 0, 1, 2 })
  {
    ComponentScene scene(lattice(), { "", 3, true }, Side, Side);
    for (int k = 0; k < 3; ++k)
    {
      scene.property()->SetComponentWeight(k, k == alone ? 1.0 : 0.0);
      scene.property()->SetScalarOpacityUnitDistance(k, 0.25);
    }
    const Image together = scene.render();
    scene.property()->SetColor(scene.property()->GetRGBTransferFunction(alone));
    scene.property()->SetScalarOpacity(scene.property()->GetScalarOpacity(alone));
    scene.Mapper->SetVectorModeToComponent();
    scene.Mapper->SetVectorComponent(alone);
    const Difference difference = compare(together, scene.render());
    EXPECT_LE(difference.Max, 2.0 / 255.0) << difference.text();
    EXPECT_LE(difference.Rms, 0.3 / 255.0) << difference.text();
  }
}

TEST(ComponentStages, BlocksOfBytesAreColorsOfBytes)
{
  const auto bytes = [](double origin)
  {
    return withComponents(withOffsetAndScale(lattice(), { origin, 0.0, 0.0 }, 1.0),
      componentFields(4), VTK_UNSIGNED_CHAR);
  };
  const Mix mix{ "", 4, false };
  ComponentScene scene(lattice(), mix, Side, Side);
  vtkPiecewiseFunction* opacity = scene.property()->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddSegment(0.0, 0.0, 255.0, 1.0);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetNumberOfBlocks(2);
  blocks->SetBlock(0, bytes(0.0));
  blocks->SetBlock(1, bytes(-3.0)); // aside
  scene.Mapper->SetInputDataObject(blocks);
  const Image joined = scene.render();
  scene.Mapper->SetInputDataObject(bytes(0.0));
  const Image alone = scene.render();
  EXPECT_LE(compare(joined, alone, {}, 0.0).Rms, 0.3 / 255.0);
  EXPECT_GT(compare(alone, Image(Side, Side)).Rms, 0.2);
}

TEST(ComponentStages, TheReferenceIsOfAllComponents)
{
  for (const Mix& mix : Mixes)
  {
    ComponentScene scene(lattice(), mix, Side, Side);
    scene.render();
    ASSERT_TRUE(scene.Mapper->CompareWithGroundTruth(scene.Volume));
    const auto* statistics = scene.Mapper->GetLastFrameStatistics();
    EXPECT_LE(statistics->GetMean(vtkTetMarchFrameStatistics::TRUE_ERROR), 1.0 / 255.0) << mix.Name;
    EXPECT_GT(statistics->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND), 0.0) << mix.Name;
    EXPECT_LE(statistics->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND), 1.0001 / 255.0)
      << mix.Name;
  }
}

// The error of light that changes along segments is bounded, too, but no tolerance limits it. It is
// far less than what light changes.
TEST(ComponentStages, TheReferenceIsInTheSameLight)
{
  for (const Mix& mix : { Mixes[3], Mixes[4] })
  {
    ComponentScene scene(lattice(), mix, Side, Side);
    const Image unlit = scene.render();
    scene.property()->ShadeOn();
    scene.Mapper->SetShadowMethodToOff();
    const Image lit = scene.render();
    ASSERT_TRUE(scene.Mapper->CompareWithGroundTruth(scene.Volume));
    const auto* statistics = scene.Mapper->GetLastFrameStatistics();
    const double worst = statistics->GetMaximum(vtkTetMarchFrameStatistics::TRUE_ERROR);
    const double bound = statistics->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND);
    std::cout << "[ MEASURED ] true error " << 255 * worst << "/255, bound " << 255 * bound
              << "/255\n";
    const double changed = compare(lit, unlit).Rms;
    EXPECT_LE(statistics->GetMean(vtkTetMarchFrameStatistics::TRUE_ERROR), 0.1 * changed)
      << mix.Name;
    EXPECT_LE(worst, bound) << mix.Name;
    EXPECT_GT(bound, 1.0 / 255.0) << mix.Name;
  }
}

// Shadows are for dependent components, and an error with independent ones.
TEST(ComponentStages, LightIsThereAsLongAsItIsAskedFor)
{
  ComponentScene scene(lattice(), { "", 4, false }, Side, Side);
  const ErrorWatch watch(scene.Mapper);
  const Image unlit = scene.render();
  const Held plain(scene);
  scene.property()->ShadeOn();
  const Image lit = scene.render();
  EXPECT_TRUE(watch.Errors.empty());
  EXPECT_GT(compare(lit, unlit).Max, 0.1);
  EXPECT_GT(Held(scene).Bytes, plain.Bytes);
  scene.property()->IndependentComponentsOn();
  scene.Mapper->SetVectorModeToAllComponents();
  scene.Window->Render();
  EXPECT_TRUE(watch.Errors.empty());
  scene.Mapper->SetShadowMethodToAutomatic();
  scene.Window->Render();
  EXPECT_EQ(watch.Errors.size(), 1u);
  scene.Mapper->SetShadowMethodToOff();
  scene.property()->IndependentComponentsOff();
  EXPECT_EQ(scene.render().Rgba, lit.Rgba);
  scene.property()->ShadeOff();
  EXPECT_EQ(scene.render().Rgba, unlit.Rgba);
  EXPECT_TRUE(Held(scene) == plain);
  EXPECT_EQ(watch.Errors.size(), 1u);
}

// Changes of other components leave the gradients as they are.
TEST(ComponentStages, GradientsFollowTheComponentOfTheOpacity)
{
  for (const Mix& mix : { Mixes[3], Mixes[4] })
  {
    const Grid grid = lattice();
    ComponentScene scene(grid, mix, Side, Side);
    scene.Mapper->SetViewModeToGradients();
    const Image before = scene.render();
    vtkDataArray* array = grid->GetPointData()->GetScalars();
    const auto reverse = [&](int component)
    {
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      {
        array->SetComponent(i, component, 1.0 - array->GetComponent(i, component));
      }
      array->Modified();
    };
    reverse(0);
    EXPECT_EQ(compare(scene.render(), before).Max, 0.0) << mix.Name;
    reverse(mix.Components - 1);
    EXPECT_GT(compare(scene.render(), before).Max, 0.1) << mix.Name;
  }
}
} // namespace
