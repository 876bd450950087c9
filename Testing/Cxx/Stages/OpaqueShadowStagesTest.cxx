// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Shadows of opaque geometry are made anew when the geometry has changed, whatever kind of prop
// shows it, and freed when they are switched off.
#include "GL/CompositeMapper.h"
#include "Held.h"
#include "LitScene.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataSetMapper.h"
#include "vtkMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;
using tetmarch::CompositeMapper;
using Mapper = vtkTetMarchVolumeMapper;

constexpr int Side = 96;
constexpr int Cubes = 8;
constexpr vtkTypeInt64 Vertices = (Cubes + 1) * (Cubes + 1) * (Cubes + 1);
constexpr vtkTypeInt64 VertexLightBytes = vertexLightBytes(Vertices);

class OpaqueShadowStages : public testing::Test
{
protected:
  OpaqueShadowStages()
  {
    this->mapper()->CollectDiagnosticsOff();
    this->mapper()->SetShadowMethodToAtVertices();
    this->Plane->SetOrigin(1.2, 2.2, 0.4);
    this->Plane->SetPoint1(2.2, 1.2, 0.4);
    this->Plane->SetPoint2(1.2, 2.2, 1.6);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->Plane->GetOutputPort());
    this->Plate->SetMapper(mapper);
  }

  Mapper* mapper() { return this->Shown.Mapper; }
  Image frame()
  {
    this->Shown.Window->Render();
    return this->Shown.frame();
  }

  // One more frame, after so many more runs of each.
  void expectRuns(const char* what, int shadows, int light)
  {
    SCOPED_TRACE(what);
    const vtkTypeInt64 shadowsBefore = this->mapper()->GetOpaqueShadowsBuilds();
    const vtkTypeInt64 lightBefore = this->mapper()->GetVertexLightBuilds();
    const vtkTypeInt64 bytesBefore = this->mapper()->GetUploadedBytes();
    this->Shown.Window->Render();
    EXPECT_EQ(this->mapper()->GetOpaqueShadowsBuilds() - shadowsBefore, shadows);
    EXPECT_EQ(this->mapper()->GetVertexLightBuilds() - lightBefore, light);
    EXPECT_EQ(this->mapper()->GetUploadedBytes() - bytesBefore, light * Vertices);
  }

  // With the plate shown by that prop as well as by itself.
  void expectShadowOf(vtkProp* prop)
  {
    this->mapper()->OpaqueShadowsOn();
    const Image lit = this->frame();
    this->Shown.Renderer->AddViewProp(this->Plate);
    const Image shadowed = this->frame();
    EXPECT_GT(compare(lit, shadowed).Max, 0.1);
    this->Shown.Renderer->RemoveViewProp(this->Plate);
    EXPECT_EQ(this->frame().Rgba, lit.Rgba);
    this->Shown.Renderer->AddViewProp(prop);
    EXPECT_EQ(this->frame().Rgba, shadowed.Rgba);
    this->Shown.Renderer->RemoveViewProp(prop);
  }

  LitScene Shown{ jitteredLattice(Cubes, 0.15, 1, sineField()), Side, Side };
  vtkNew<vtkPlaneSource> Plane;
  vtkNew<vtkActor> Plate;
};

TEST_F(OpaqueShadowStages, WhatIsOffCostsNothing)
{
  this->Shown.Renderer->AddActor(this->Plate);
  this->Shown.Window->Render();
  const Held off(this->Shown);
  this->mapper()->OpaqueShadowsOn();
  this->Shown.Window->Render();
  EXPECT_EQ(this->mapper()->GetGPUMemoryBytes() - off.Bytes, Vertices);
  EXPECT_EQ(this->mapper()->GetOpaqueShadowsBuilds(), 1);
  EXPECT_GT(this->mapper()->GetOpaqueShadowsSeconds(), 0.0);
  this->mapper()->OpaqueShadowsOff();
  this->Shown.Window->Render();
  EXPECT_TRUE(Held(this->Shown) == off);
  // Nor is it there without anything that casts shadows.
  this->Plate->VisibilityOff();
  this->Shown.Window->Render();
  const Held alone(this->Shown);
  this->mapper()->OpaqueShadowsOn();
  this->Shown.Window->Render();
  EXPECT_TRUE(Held(this->Shown) == alone);
  this->Plate->VisibilityOn();
  this->mapper()->SetShadowMethodToOff();
  this->Shown.Window->Render();
  EXPECT_EQ(this->mapper()->GetGPUMemoryBytes(), off.Bytes - VertexLightBytes);
  EXPECT_EQ(this->mapper()->GetOpaqueShadowsBuilds(), 1);
}

TEST_F(OpaqueShadowStages, AlongRaysSurfacesAreSearchedAndVerticesKnowNothing)
{
  this->Shown.Renderer->AddActor(this->Plate);
  this->mapper()->SetShadowMethodToAlongRays();
  this->Shown.Window->Render();
  const Held off(this->Shown);
  EXPECT_EQ(this->mapper()->GetVertexLightBuilds(), 0);
  this->mapper()->OpaqueShadowsOn();
  this->Shown.Window->Render();
  // The place of the plate, a tree of one leaf, and two triangles.
  constexpr vtkTypeInt64 surfaceBytes = 16 * (4 + 2 * 2 + 2 * 3);
  EXPECT_EQ(this->mapper()->GetGPUMemoryBytes() - off.Bytes, surfaceBytes);
  EXPECT_EQ(this->mapper()->GetVertexLightBuilds(), 0);
  const auto expectUploaded = [&](const char* what, vtkTypeInt64 bytes)
  {
    const vtkTypeInt64 before = this->mapper()->GetUploadedBytes();
    this->Shown.Window->Render();
    EXPECT_EQ(this->mapper()->GetUploadedBytes() - before, bytes) << what;
  };
  this->Shown.camera()->Azimuth(10.0);
  expectUploaded("camera", 0);
  this->Shown.camera()->Azimuth(-10.0);
  this->Shown.Sun->SetPosition(3.0, 4.0, 1.0);
  expectUploaded("direction", 0);
  this->Plate->AddPosition(0.25, 0.35, 0.1);
  expectUploaded("along the light", surfaceBytes);
  this->mapper()->OpaqueShadowsOff();
  this->Shown.Window->Render();
  EXPECT_TRUE(Held(this->Shown) == off);
  EXPECT_GT(off.Bytes, JitterBytes);
}

TEST_F(OpaqueShadowStages, OnlyWhatChangedIsRedone)
{
  this->Shown.Renderer->AddActor(this->Plate);
  this->mapper()->OpaqueShadowsOn();
  this->Shown.Window->Render();
  const int shaders = countShaders();
  this->expectRuns("nothing", 0, 0);
  this->Shown.camera()->Azimuth(20.0);
  this->Shown.camera()->Zoom(1.2);
  this->expectRuns("camera", 0, 0);
  this->Shown.Sun->SetIntensity(0.7);
  this->expectRuns("intensity", 0, 0);
  this->Plate->AddPosition(0.1, -0.1, 0.05);
  this->expectRuns("across the light", 1, 1);
  this->Plate->AddPosition(0.25, 0.35, 0.1);
  this->expectRuns("along the light", 1, 0);
  this->Plate->AddPosition(-0.25, -0.35, -0.1);
  this->Plane->SetPoint1(1.6, 1.8, 0.4);
  this->expectRuns("data", 1, 1);
  this->Shown.Sun->SetPosition(3.0, 4.0, 1.0);
  this->expectRuns("direction", 1, 1);
  this->Shown.Volume->RotateY(20.0);
  this->expectRuns("place of the volume", 1, 1);
  EXPECT_EQ(countShaders(), shaders);
}

// Geometry is collected while the assembly itself iterates over its parts.
TEST_F(OpaqueShadowStages, AnAssemblyOfPlateAndVolume)
{
  this->mapper()->OpaqueShadowsOn();
  this->Shown.Renderer->AddActor(this->Plate);
  const Image apart = this->frame();
  this->Shown.Renderer->RemoveActor(this->Plate);
  this->Shown.Renderer->RemoveVolume(this->Shown.Volume);
  vtkNew<vtkAssembly> both;
  both->AddPart(this->Shown.Volume);
  both->AddPart(this->Plate);
  this->Shown.Renderer->AddViewProp(both);
  EXPECT_EQ(this->frame().Rgba, apart.Rgba);
  both->AddPosition(0.0, 0.0, 0.1);
  this->expectRuns("both", 1, 0); // the shadow is the same
  this->Plate->AddPosition(0.1, -0.1, 0.05);
  this->expectRuns("the plate", 1, 1);
}

// Out of sight the mapper of a plate has drawn nothing.
TEST_F(OpaqueShadowStages, WhatIsOutOfSightCastsShadows)
{
  this->mapper()->OpaqueShadowsOn();
  this->Plate->AddPosition(7.5, 10.5, 3.0); // along the light
  const Image lit = this->frame();
  this->Shown.Renderer->AddActor(this->Plate);
  const Image shadowed = this->frame();
  EXPECT_GT(compare(lit, shadowed).Max, 0.1);
  this->Plane->SetResolution(2, 2);
  this->expectRuns("data", 1, 0);
}

TEST_F(OpaqueShadowStages, OfADataSetMapper)
{
  this->Plane->Update();
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputData(this->Plane->GetOutput());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->expectShadowOf(actor);
}

TEST_F(OpaqueShadowStages, OfBlocksThatAreVisible)
{
  this->Plane->Update();
  vtkNew<vtkPolyData> large;
  large->ShallowCopy(this->Plane->GetOutput());
  vtkNew<vtkPlaneSource> everything;
  everything->SetOrigin(-9.0, -9.0, 5.0);
  everything->SetPoint1(19.0, -9.0, 5.0);
  everything->SetPoint2(-9.0, 19.0, 5.0);
  everything->Update();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, everything->GetOutput());
  blocks->SetBlock(1, large);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  mapper->SetCompositeDataDisplayAttributes(attributes);
  attributes->SetBlockVisibility(everything->GetOutput(), false);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->expectShadowOf(actor);
}
} // namespace
