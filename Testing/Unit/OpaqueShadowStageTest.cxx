// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Shadows of opaque geometry are made when something has changed, and freed when nothing casts any.
#include "ShadowedEffects.h"

#include "vtkCompositePolyDataMapper.h"
#include "vtkMultiBlockDataSet.h"

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

class OpaqueShadowStage : public ShadowedEffects
{
};

// The search tree is kept while the data stay; shadows are made for each place of the geometry.
TEST_F(OpaqueShadowStage, AnActorThatMoves)
{
  this->addLight(0.3, 0.2, 1.0);
  const auto actor = plateAt(1.3);
  this->Renderer->AddActor(actor);
  const auto depth = [](double z) {
    return [z](const Vector3& p) { return depthUnderPlate(p, { { 0.3, 0.2, 1.0 } }, z); };
  };
  this->expectShadow(0, depth(1.3), Rounding);
  const Fingerprint version = this->Stage.opaqueShadowsVersion();
  this->shadows();
  EXPECT_EQ(this->Stage.opaqueShadowsRecord().Runs, 1);
  actor->SetPosition(0.0, 0.0, -0.2);
  this->expectShadow(0, depth(1.1), Rounding);
  EXPECT_EQ(this->Stage.opaqueShadowsRecord().Runs, 2);
  EXPECT_EQ(this->Stage.data().Opaque.numberOfHierarchies(), 1);
  EXPECT_NE(this->Stage.opaqueShadowsVersion(), version);
  // Along the light no vertex sees a difference, and nothing has to be uploaded.
  const Fingerprint moved = this->Stage.opaqueShadowsVersion();
  actor->AddPosition(0.3, 0.2, 1.0);
  this->expectShadow(0, depth(1.1), Rounding);
  EXPECT_EQ(this->Stage.opaqueShadowsRecord().Runs, 3);
  EXPECT_EQ(this->Stage.opaqueShadowsVersion(), moved);
  auto* data = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  data->GetPoints()->SetPoint(3, 5.0, 5.0, 1.3);
  data->Modified();
  this->shadows();
  EXPECT_EQ(this->Stage.data().Opaque.numberOfHierarchies(), 2);
  EXPECT_NE(this->Stage.opaqueShadowsVersion(), moved);
}

TEST_F(OpaqueShadowStage, LightAndVolumeRedoThemAndTheCameraDoesNot)
{
  const auto sun = this->addLight(0.3, 0.2, 1.0);
  this->Renderer->AddActor(plateAt(1.3));
  int runs = 0;
  const auto expectRun = [&](int more)
  {
    EXPECT_EQ(this->update(), "");
    runs += more;
    EXPECT_EQ(this->Stage.opaqueShadowsRecord().Runs, runs);
  };
  expectRun(1);
  this->Renderer->GetActiveCamera()->SetPosition(3.0, 2.0, 1.0);
  sun->SetIntensity(0.3);
  sun->SetShadowAttenuation(0.5f);
  this->property()->SetDiffuse(0.3);
  this->property()->SetScalarOpacityUnitDistance(7.0);
  this->Options.Occlusion = true;
  this->touchScalars();
  expectRun(0);
  // Along rays the triangles themselves are searched.
  this->Options.Shadows = ShadowMethod::AlongRays;
  expectRun(1);
  EXPECT_TRUE(this->Stage.data().ShadowedVertices.empty());
  const Fingerprint version = this->Stage.data().Opaque.version();
  sun->SetPosition(0.1, 0.2, 1.0);
  expectRun(1);
  EXPECT_EQ(this->Stage.data().Opaque.version(), version);
  this->Volume->RotateX(30.0);
  expectRun(1);
  EXPECT_NE(this->Stage.data().Opaque.version(), version);
  this->Volume->AddPosition(0.0, 0.0, 0.1); // the direction to the light stays the same
  expectRun(1);
  this->Options.Reach = 0.8;
  expectRun(1);
  this->touchMesh();
  expectRun(1);
  EXPECT_EQ(this->Stage.data().Opaque.numberOfHierarchies(), 1);
}

// A ray searches one surface after the other, so there should be few.
TEST_F(OpaqueShadowStage, BlocksOfOneMapperAreOneSurface)
{
  this->addLight(0.3, 0.2, 1.0);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, plate({ { 0.2, 0.3, 1.3 } }, { { 0.4, 0.3, 1.3 } }, { { 0.2, 0.9, 1.3 } }));
  blocks->SetBlock(1, plate({ { 0.4, 0.3, 1.3 } }, { { 0.7, 0.3, 1.3 } }, { { 0.4, 0.9, 1.3 } }));
  vtkNew<vtkCompositePolyDataMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Renderer->AddActor(actor);
  this->expectShadow(
    0,
    [](const Vector3& p) {
      return depthUnderPlate(p, { { 0.3, 0.2, 1.0 } }, 1.3);
    },
    Rounding);
  EXPECT_EQ(this->Stage.data().Opaque.size(), 1u);
  this->Renderer->AddActor(plateAt(1.3));
  this->shadows();
  EXPECT_EQ(this->Stage.data().Opaque.size(), 2u);
}

TEST_F(OpaqueShadowStage, WhatIsOffMakesNothing)
{
  this->addLight(0.3, 0.2, 1.0);
  const auto actor = plateAt(1.3);
  this->Renderer->AddActor(actor);
  this->Options.OpaqueShadows = false;
  this->expectNone();
  this->Options.OpaqueShadows = true;
  this->Options.Shadows = ShadowMethod::Off;
  this->expectNone();
  this->Options.Shadows = ShadowMethod::AtVertices;
  this->property()->ShadeOff();
  this->expectNone();
  this->property()->ShadeOn();
  this->Renderer->RemoveAllLights();
  this->addHeadlight();
  this->expectNone();
  EXPECT_EQ(this->Stage.opaqueShadowsRecord().Runs, 0);
  this->addLight(0.3, 0.2, 1.0);
  EXPECT_FALSE(this->shadows().empty());
  this->Renderer->RemoveActor(actor);
  this->expectNone();
  EXPECT_EQ(this->Stage.opaqueShadowsRecord().Runs, 1);
  // What scatters light casts shadows, too.
  this->Renderer->AddActor(actor);
  this->Options.Shadows = ShadowMethod::Off;
  this->Options.Scattering = 1.0;
  EXPECT_FALSE(this->shadows().empty());
  this->Stage.clear();
  EXPECT_TRUE(this->Stage.data().ShadowedVertices.empty());
}

TEST_F(OpaqueShadowStage, AnActorWithoutVolume)
{
  this->addLight(0.3, 0.2, 1.0);
  const auto actor = plateAt(1.3);
  vtkNew<vtkMatrix4x4> nowhere;
  nowhere->Zero();
  actor->SetUserMatrix(nowhere);
  this->Renderer->AddActor(actor);
  this->expectNone();
}
} // namespace
