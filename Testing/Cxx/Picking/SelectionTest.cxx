// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A selection among other props, and what it leaves behind.
#include "ErrorWatch.h"
#include "Held.h"
#include "Observer.h"
#include "PickScene.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkProperty.h"
#include "vtkTetMarchFrameStatistics.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

constexpr int Middle = SceneSize / 2;

class Selection : public testing::Test
{
protected:
  Selection() { this->Shown.property()->SetScalarOpacityUnitDistance(0.1); }

  vtkProp* volume() { return this->Shown.Volume; }
  // The only prop in the middle.
  vtkProp* selectedProp()
  {
    const Selected found = this->Shown.select(Middle, Middle, Middle, Middle);
    EXPECT_LE(found.size(), 1u);
    return found.empty() ? nullptr : found.begin()->first;
  }

  PickScene Shown{ jitteredLattice(5, 0.15, 1, sineField()) };
};

TEST_F(Selection, OpaqueGeometryBeforeTheVolume)
{
  const auto line = this->Shown.lineOf(Middle, Middle);
  ASSERT_EQ(this->selectedProp(), this->volume());
  ASSERT_TRUE(this->Shown.pick(Middle, Middle));
  const Vec3 hit = this->Shown.pickedPosition();
  const double far =
    std::hypot(hit[0] - line.Near[0], hit[1] - line.Near[1], hit[2] - line.Near[2]);
  const auto before = makeBall(line.at(far - 0.06), 0.05, { 1.0, 1.0, 1.0 });
  this->Shown.Renderer->AddActor(before);
  EXPECT_EQ(this->selectedProp(), before.Get());
  EXPECT_FALSE(this->Shown.pick(Middle, Middle));
  // One that is translucent is drawn by the selector all the same; one that can't be picked isn't.
  before->GetProperty()->SetOpacity(0.3);
  EXPECT_EQ(this->selectedProp(), before.Get());
  before->PickableOff();
  EXPECT_EQ(this->selectedProp(), this->volume());
  this->Shown.Renderer->RemoveActor(before);

  const auto behind = makeBall(line.at(far + 0.06), 0.05, { 1.0, 1.0, 1.0 });
  this->Shown.Renderer->AddActor(behind);
  EXPECT_EQ(this->selectedProp(), this->volume());
  ASSERT_TRUE(this->Shown.pick(Middle, Middle));
  EXPECT_EQ(this->Shown.pickedPosition(), hit);
  this->Shown.Volume->PickableOff();
  EXPECT_EQ(this->selectedProp(), behind.Get());
}

TEST_F(Selection, TheNearerOfTwoVolumes)
{
  vtkNew<vtkTetMarchVolumeMapper> mapper;
  mapper->SetInputData(hexLattice(3));
  vtkNew<vtkVolume> other;
  other->SetMapper(mapper);
  other->SetProperty(this->Shown.property());
  this->Shown.Renderer->AddVolume(other);
  const auto line = this->Shown.lineOf(Middle, Middle);
  for (const double shift : { 2.0, -2.0 })
  {
    // Along the ray, away or towards the eye.
    other->SetPosition(
      shift * line.Direction[0], shift * line.Direction[1], shift * line.Direction[2]);
    EXPECT_EQ(this->selectedProp(), shift > 0 ? this->volume() : other.Get());
    EXPECT_EQ(this->Shown.pick(Middle, Middle), shift > 0);
    EXPECT_EQ(mapper->Pick(this->Shown.Renderer, other, Middle, Middle), shift < 0);
  }
}

TEST_F(Selection, OfPointsFindsNothing)
{
  EXPECT_EQ(this->Shown.selectAll().count(this->volume()), 1u);
  EXPECT_TRUE(this->Shown.selectAll(vtkDataObject::FIELD_ASSOCIATION_POINTS).empty());
  const auto ball = makeBall({ 0.5, 0.5, 0.5 }, 0.2, { 1.0, 1.0, 1.0 });
  this->Shown.Renderer->AddActor(ball);
  const Selected found = this->Shown.selectAll(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  EXPECT_EQ(found.count(this->volume()), 0u);
  EXPECT_EQ(found.count(ball), 1u);
}

// With shadows there is more state that a selection could spoil.
TEST_F(Selection, LeavesNothingBehind)
{
  this->Shown.property()->ShadeOn();
  this->Shown.Mapper->SetShadowMethod(vtkTetMarchVolumeMapper::SHADOWS_ALONG_RAYS);
  this->Shown.Mapper->AmbientOcclusionOn();
  const Image picture = this->Shown.render();
  const Image frame = this->Shown.frame();
  vtkTetMarchFrameStatistics* statistics = this->Shown.Mapper->GetLastFrameStatistics();
  const double bound = statistics->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND);
  ASSERT_GT(bound, 0.0);
  this->Shown.selectAll();
  EXPECT_EQ(statistics->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND), bound);
  EXPECT_EQ(compare(picture, floatPictureOf(this->Shown.Mapper, SceneSize, SceneSize)).Max, 0.0);
  const Held held(this->Shown);
  const vtkTypeInt64 uploaded = this->Shown.Mapper->GetUploadedBytes();
  for (int i = 0; i < 20; ++i)
  {
    EXPECT_EQ(this->Shown.select(3 * i, 4 * i, 60 + 5 * i, 80 + 2 * i).size(), 1u);
    EXPECT_TRUE(Held(this->Shown) == held);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
  EXPECT_EQ(compare(picture, this->Shown.render()).Max, 0.0);
  EXPECT_EQ(compare(frame, this->Shown.frame()).Max, 0.0);
  EXPECT_TRUE(Held(this->Shown) == held);
  EXPECT_EQ(this->Shown.Mapper->GetUploadedBytes(), uploaded);
  EXPECT_EQ(this->Shown.Mapper->GetTablesBuilds(), 1);
  EXPECT_EQ(this->Shown.Mapper->GetVertexLightBuilds(), 1);
}

// The rays of a selection end at opaque geometry, also in a scene whose pictures have none.
TEST_F(Selection, HoldsNothing)
{
  this->Shown.render();
  this->Shown.selectAll(); // VTK's own
  this->Shown.render();
  const Held held(this->Shown);
  EXPECT_TRUE(this->Shown.pick(Middle, Middle));
  this->Shown.selectAll();
  EXPECT_TRUE(Held(this->Shown) == held);
}

// Counts marches of picks by the mapper's progress, which grows from tile to tile of each.
class MarchCount
{
public:
  explicit MarchCount(vtkTetMarchVolumeMapper* mapper)
    : Watch(mapper, vtkCommand::ProgressEvent,
        [this, mapper]
        {
          const double share = mapper->GetProgress();
          const bool ofTiles = share > 0.0 && share < 1.0; // else of the mapper's Update()
          this->Marches += ofTiles && share <= this->Last;
          this->Last = ofTiles ? share : this->Last;
        })
  {
    mapper->SetMaxDrawTimeInSeconds(1e-9); // the smallest tiles
  }

  int Marches = 0;

private:
  double Last = 1.0;
  Observer Watch;
};

// A selector renders the props, the blocks and the cells, the blocks twice.
TEST_F(Selection, MarchesOnceForAllPasses)
{
  this->Shown.render();
  const Selected expected = this->Shown.selectAll();
  ASSERT_GT(expected.at(this->volume()).size(), 8u);
  MarchCount count(this->Shown.Mapper);
  EXPECT_EQ(this->Shown.selectAll(), expected);
  EXPECT_EQ(count.Marches, 1);
  EXPECT_EQ(this->Shown.selectAll(), expected);
  EXPECT_EQ(count.Marches, 2) << "nothing is kept from one selection to the next";
}

TEST_F(Selection, SeesWhatHasChangedSinceTheLast)
{
  const Selected before = this->Shown.selectAll();
  vtkCamera* camera = this->Shown.camera();
  camera->Azimuth(100.0);
  camera->Elevation(30.0);
  const Selected after = this->Shown.selectAll();
  EXPECT_NE(after, before);
  this->Shown.property()->SetScalarOpacityUnitDistance(1e-3);
  EXPECT_NE(this->Shown.selectAll(), after);
  camera->Elevation(-30.0);
  camera->Azimuth(-100.0);
  this->Shown.property()->SetScalarOpacityUnitDistance(0.1);
  EXPECT_EQ(this->Shown.selectAll(), before);
}

// An observer may turn the camera between the passes of one selection.
TEST_F(Selection, MarchesAgainIfAPassHasAnotherCamera)
{
  this->Shown.render();
  MarchCount count(this->Shown.Mapper);
  int passes = 0;
  const Observer turn(this->Shown.Renderer, vtkCommand::StartEvent,
    [&]
    {
      this->Shown.camera()->Azimuth(5.0);
      ++passes;
    });
  this->Shown.selectAll();
  ASSERT_GT(passes, 3);
  EXPECT_GT(count.Marches, 3);
}

// A budget chooses levels by the time of past frames; selections don't count as frames.
TEST_F(Selection, IsNoFrameForTheBudgets)
{
  this->Shown.Mapper->SetFrameTimeBudget(1000.0);
  for (int i = 0; i < 4; ++i)
  {
    this->Shown.render();
  }
  const int level = this->Shown.Mapper->GetUsedAccuracyLevel();
  const vtkTypeInt64 tables = this->Shown.Mapper->GetTablesBuilds();
  ASSERT_TRUE(this->Shown.Mapper->IsBudgetKept());
  EXPECT_TRUE(this->Shown.pick(Middle, Middle));
  EXPECT_TRUE(this->Shown.Mapper->IsBudgetKept());
  EXPECT_EQ(this->Shown.Mapper->GetUsedAccuracyLevel(), level);
  EXPECT_EQ(this->Shown.Mapper->GetTablesBuilds(), tables);
}

TEST_F(Selection, OfNothing)
{
  const Grid sound = this->Shown.Data;
  this->Shown.Mapper->SetInputData(emptyGrid());
  ErrorWatch watch(this->Shown.Mapper);
  EXPECT_TRUE(this->Shown.selectAll().empty());
  EXPECT_FALSE(this->Shown.pick(Middle, Middle));
  EXPECT_EQ(watch.Errors.size(), 0u);

  this->Shown.Mapper->SetInputData(sound);
  this->Shown.Mapper->SetScalarModeToUsePointFieldData();
  this->Shown.Mapper->SelectScalarArray("there is none");
  EXPECT_TRUE(this->Shown.selectAll().empty());
  EXPECT_FALSE(this->Shown.pick(Middle, Middle));
  ASSERT_EQ(watch.Errors.size(), 1u);
  EXPECT_NE(watch.Errors[0].find("there is none"), std::string::npos) << watch.Errors[0];
  this->Shown.Mapper->SelectScalarArray("f");
  EXPECT_TRUE(this->Shown.pick(Middle, Middle));
  EXPECT_EQ(watch.Errors.size(), 1u);
}

TEST_F(Selection, PicksNothingElse)
{
  ErrorWatch watch(this->Shown.Mapper);
  vtkNew<vtkVolume> stranger;
  vtkNew<vtkRenderer> homeless;
  vtkTetMarchVolumeMapper* mapper = this->Shown.Mapper;
  EXPECT_FALSE(mapper->Pick(this->Shown.Renderer, stranger, Middle, Middle));
  EXPECT_FALSE(mapper->Pick(this->Shown.Renderer, nullptr, Middle, Middle));
  EXPECT_FALSE(mapper->Pick(homeless, this->Shown.Volume, Middle, Middle));
  EXPECT_FALSE(mapper->Pick(nullptr, this->Shown.Volume, Middle, Middle));
  EXPECT_EQ(watch.Errors.size(), 4u);
}
} // namespace
