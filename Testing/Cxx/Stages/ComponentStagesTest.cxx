// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a change of components, of their functions and weights makes anew, what is freed with them,
// and what can't be drawn.
#include "vtkTetMarchFrameStatistics.h"

#include "ComponentScene.h"
#include "ErrorWatch.h"
#include "Held.h"
#include "PickScene.h"

#include "vtkDataArray.h"
#include "vtkMultiBlockDataSet.h"

#include <cmath>
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
  // A function is not.
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
    const vtkTypeInt64 further = mix.Components == 4 ? 16 : 4 * (mix.Components - 1);
    const vtkTypeInt64 scalars = (16 + further) * grid->GetNumberOfPoints();
    EXPECT_GE(second.Bytes - first.Bytes, scalars) << mix.Name;
    EXPECT_LE(second.Bytes - first.Bytes, scalars + 40 * 4 * 65536) << mix.Name; // and new tables
    scene.render();
    EXPECT_EQ(Made(scene.Mapper).Bytes, second.Bytes);
  }
}

// A component of no weight is not there; and one alone is drawn as ever.
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

// Light that changes along pieces is bounded, too, but kept by no tolerance.
TEST(ComponentStages, TheReferenceIsInTheSameLight)
{
  for (const Mix& mix : { Mixes[3], Mixes[4] })
  {
    ComponentScene scene(lattice(), mix, Side, Side);
    scene.property()->ShadeOn();
    scene.Mapper->SetShadowMethodToOff();
    const Image lit = scene.render();
    ASSERT_TRUE(scene.Mapper->CompareWithGroundTruth(scene.Volume));
    const auto* statistics = scene.Mapper->GetLastFrameStatistics();
    const double worst = statistics->GetMaximum(vtkTetMarchFrameStatistics::TRUE_ERROR);
    const double bound = statistics->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND);
    std::cout << "[ MEASURED ] true error " << 255 * worst << "/255, bound " << 255 * bound
              << "/255\n";
    EXPECT_LE(statistics->GetMean(vtkTetMarchFrameStatistics::TRUE_ERROR), 1.0 / 255.0) << mix.Name;
    EXPECT_LE(worst, bound) << mix.Name;
    EXPECT_GT(bound, 1.0 / 255.0) << mix.Name;
  }
}

class ComponentErrors : public ::testing::Test
{
protected:
  void expectError(const std::string& words)
  {
    const ErrorWatch watch(this->Shown.Mapper);
    this->Shown.Window->Render();
    this->Shown.Window->Render();
    ASSERT_EQ(watch.Errors.size(), 1u);
    EXPECT_NE(watch.Errors[0].find(words), std::string::npos) << watch.Errors[0];
    EXPECT_EQ(compare(this->Shown.frame(), this->Empty).Max, 0.0);
  }
  void expectMended()
  {
    const ErrorWatch watch(this->Shown.Mapper);
    this->Shown.Window->Render();
    EXPECT_TRUE(watch.Errors.empty());
    EXPECT_EQ(this->Shown.frame().Rgba, this->Sound.Rgba);
  }
  void SetUp() override
  {
    this->Shown.Volume->VisibilityOff();
    this->Shown.Window->Render();
    this->Empty = this->Shown.frame();
    this->Shown.Volume->VisibilityOn();
    this->Shown.Window->Render();
    this->Sound = this->Shown.frame();
    EXPECT_GT(compare(this->Sound, this->Empty).Max, 0.1);
  }

  ComponentScene Shown{ lattice(), { "", 3, true }, Side, Side };
  Image Empty;
  Image Sound;
};

TEST_F(ComponentErrors, OtherBlendModes)
{
  for (const int mode :
    { Mapper::MAXIMUM_INTENSITY_BLEND, Mapper::ADDITIVE_BLEND, Mapper::ISOSURFACE_BLEND })
  {
    this->Shown.Mapper->SetBlendMode(mode);
    this->expectError("composite blending alone");
    this->Shown.Mapper->SetBlendModeToComposite();
    this->expectMended();
  }
}

TEST_F(ComponentErrors, LightAndGradients)
{
  this->Shown.property()->ShadeOn();
  this->expectError("independent components are drawn together without light");
  this->Shown.property()->ShadeOff();
  this->expectMended();
  for (const int view : { Mapper::VIEW_GRADIENTS, Mapper::VIEW_ILLUMINATION })
  {
    this->Shown.Mapper->SetViewMode(view);
    this->expectError("without light");
    this->Shown.Mapper->SetViewModeToPicture();
    this->expectMended();
  }
  this->Shown.property()->GetGradientOpacity()->AddSegment(0.0, 0.0, 5.0, 1.0);
  this->expectError("gradient opacity");
  this->Shown.property()->GetGradientOpacity()->RemoveAllPoints();
  this->Shown.property()->DisableGradientOpacityOn();
  this->expectMended();
}

// What dependent ones are drawn with is an error with independent ones.
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
  EXPECT_EQ(watch.Errors.size(), 1u);
  scene.property()->IndependentComponentsOff();
  EXPECT_EQ(scene.render().Rgba, lit.Rgba);
  scene.property()->ShadeOff();
  EXPECT_EQ(scene.render().Rgba, unlit.Rgba);
  EXPECT_TRUE(Held(scene) == plain);
  EXPECT_EQ(watch.Errors.size(), 1u);
}

// Another component may change as it likes.
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

TEST_F(ComponentErrors, NumbersOfComponents)
{
  this->Shown.property()->IndependentComponentsOff();
  this->expectError("\"components\" has 3 components");
  this->Shown.property()->IndependentComponentsOn();
  this->expectMended();
  this->Shown.property()->SetScalarOpacityUnitDistance(1, -1.0);
  this->expectError("of component 1 is -1");
  this->Shown.property()->SetScalarOpacityUnitDistance(1, 0.375);
  this->expectMended();
}

// The component of the opacity is picked, through its gradient opacity.
TEST(ComponentPick, GoesByTheGradientOfTheOpacity)
{
  for (const Mix& mix : { Mixes[3], Mixes[4] })
  {
    PickScene scene(withComponents(lattice(), wavyFields(mix.Components), VTK_DOUBLE), Side, Side);
    drawComponents(scene, mix);
    const int at = Side / 2;
    const auto pick = [&]
    {
      scene.render();
      EXPECT_TRUE(scene.pick(at, at)) << mix.Name;
      return scene.pickedPosition();
    };
    scene.property()->SetScalarOpacityUnitDistance(0.01);
    const Vec3 even = pick();
    setGradientOpacity(scene.property());
    const Vec3 together = pick();
    scene.Mapper->SetVectorModeToComponent();
    scene.Mapper->SetVectorComponent(mix.Components - 1);
    const Vec3 alone = pick();
    EXPECT_EQ(together, alone) << mix.Name;
    EXPECT_NE(together, even) << mix.Name;
  }
}

// Everywhere the same: half of the light is gone where the extinctions together say so.
TEST(ComponentPick, GoesByAllComponents)
{
  for (const Mix& mix : Mixes)
  {
    std::vector<Field> fields;
    for (int k = 0; k < mix.Components; ++k)
    {
      fields.push_back(constantField(0.3 + 0.1 * k));
    }
    const Grid grid = withComponents(lattice(), fields, VTK_DOUBLE);
    for (const bool cells : { false, true })
    {
      PickScene scene(grid, Side, Side);
      setComponentFunctions(scene.property(), mix.Components);
      scene.property()->SetIndependentComponents(mix.Independent);
      scene.Mapper->SetVectorModeToAllComponents();
      if (cells)
      {
        scene.Mapper->SetScalarModeToUseCellData();
      }
      std::vector<double> scalars(mix.Components);
      grid->GetPointData()->GetScalars()->GetTuple(0, scalars.data());
      const double extinction = mediumAt(scene.property(), scalars)[3] / 0.25;
      scene.render();
      const int at = Side / 2;
      ASSERT_TRUE(scene.pick(at, at)) << mix.Name;
      const auto line = scene.lineOf(at, at);
      const Vec3 picked = scene.pickedPosition();
      double distance = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        distance += (picked[k] - line.Near[k]) * line.Direction[k];
      }
      const double inside =
        boxChord(line.at(distance), { -line.Direction[0], -line.Direction[1], -line.Direction[2] },
          { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, 0.0);
      EXPECT_NEAR(inside, std::log(2.0) / extinction, 1e-5) << mix.Name;
      EXPECT_NEAR(
        scene.Mapper->GetPickedScalar(), mix.Independent ? scalars[0] : scalars.back(), 1e-6);
    }
  }
}
} // namespace
