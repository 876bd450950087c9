// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Planes that move from frame to frame make nothing anew; cuts that leave everything cost nothing;
// planes without a normal are an error.
#include "CutScene.h"
#include "ErrorScene.h"
#include "Held.h"

#include <cmath>
#include <functional>
#include <limits>

namespace
{
using namespace tetmarch::testing;
using Mapper = vtkTetMarchVolumeMapper;

std::array<vtkTypeInt64, 7> workOf(const Mapper* mapper)
{
  return { { mapper->GetMeshBuilds(), mapper->GetScalarsBuilds(), mapper->GetTablesBuilds(),
    mapper->GetGradientsBuilds(), mapper->GetOpaqueShadowsBuilds(), mapper->GetVertexLightBuilds(),
    mapper->GetUploadedBytes() } };
}

class ClippingStages : public ::testing::Test
{
protected:
  ClippingStages()
  {
    this->mapper()->SetShadowMethodToAtVertices();
    this->Whole = this->Shown.render();
  }

  // Each move changes the picture, with the same shaders and the same buffers.
  void expectOnlyDrawn(const std::vector<std::function<void()>>& moves)
  {
    Image before = this->Shown.render();
    const Held held(this->Shown);
    const int shaders = countShaders();
    const auto work = workOf(this->mapper());
    for (const auto& move : moves)
    {
      move();
      const Image after = this->Shown.render();
      EXPECT_GT(compare(before, after).Max, 0.02);
      EXPECT_TRUE(Held(this->Shown) == held);
      EXPECT_EQ(countShaders(), shaders);
      EXPECT_EQ(workOf(this->mapper()), work);
      before = after;
    }
  }

  void expectWhole() { EXPECT_EQ(compare(this->Shown.render(), this->Whole).Max, 0.0); }

  Mapper* mapper() { return this->Shown.Mapper; }

  LitScene Shown{ jitteredLattice(8, 0.15, 1, sineField()), 96, 96 };
  Image Whole;
};

TEST_F(ClippingStages, PlanesMoveWithoutWork)
{
  const auto plane = clipObliquely(this->Shown);
  vtkNew<vtkPlane> second;
  second->SetOrigin(0.5, 0.6, 0.5);
  second->SetNormal(0.0, -1.0, 0.2);
  this->expectOnlyDrawn(
    { [&] { plane->SetOrigin(0.4, 0.4, 0.6); }, [&] { plane->SetNormal(0.6, 0.1, -1.0); },
      [&] { this->mapper()->AddClippingPlane(second); }, [&] { second->SetOrigin(0.5, 0.4, 0.5); },
      [&] { this->mapper()->RemoveClippingPlane(plane); } });
  this->mapper()->RemoveAllClippingPlanes();
  this->expectWhole();
}

TEST_F(ClippingStages, ABoxIsCutByPlanes)
{
  clipObliquely(this->Shown);
  this->expectOnlyDrawn({ [&] { crop(this->Shown, VTK_CROP_SUBVOLUME); },
    [&] { this->mapper()->SetCroppingRegionPlanes(0.1, 0.9, 0.1, 0.9, 0.1, 0.9); },
    [&] { this->mapper()->SetCroppingRegionFlags(0x0000001); },
    [&] { this->mapper()->CroppingOff(); } });
  this->mapper()->RemoveAllClippingPlanes();
  this->expectWhole();
}

TEST_F(ClippingStages, RegionsChangeWithoutWork)
{
  crop(this->Shown, VTK_CROP_FENCE);
  this->expectOnlyDrawn(
    { [&] { this->mapper()->SetCroppingRegionPlanes(0.1, 0.4, 0.3, 0.9, 0.5, 0.9); },
      [&] { this->mapper()->SetCroppingRegionFlagsToInvertedCross(); },
      [&] { this->mapper()->SetCroppingRegionFlagsToCross(); },
      [&] { clipObliquely(this->Shown); } });
  this->mapper()->CroppingOff();
  this->mapper()->RemoveAllClippingPlanes();
  this->expectWhole();
}

TEST_F(ClippingStages, WhatCutsNothingChangesNoBit)
{
  const int shaders = countShaders();
  crop(this->Shown, 0x7ffffff);
  this->expectWhole();
  this->mapper()->CroppingOff();
  this->mapper()->AddClippingPlane(vtkNew<vtkPlane>());
  this->mapper()->RemoveAllClippingPlanes(); // a collection of none stays
  this->expectWhole();
  EXPECT_EQ(countShaders(), shaders);
  // A plane beside the mesh needs another shader, but the picture stays the same.
  addClippingPlane(this->Shown, { -0.5, -0.5, -0.5 }, { 1.0, 2.0, 3.0 });
  this->expectWhole();
  EXPECT_GT(countShaders(), shaders);
}

TEST_F(ClippingStages, TheBoundaryIsNotCut)
{
  this->mapper()->SetViewModeToBoundaryFaces();
  this->Shown.Window->Render();
  const Image boundary = this->Shown.frame();
  const int shaders = countShaders();
  clipObliquely(this->Shown);
  crop(this->Shown, VTK_CROP_FENCE);
  this->Shown.Window->Render();
  EXPECT_EQ(compare(this->Shown.frame(), boundary).Max, 0.0);
  EXPECT_EQ(countShaders(), shaders);
}

TEST_F(ClippingStages, LightThatPassesThroughPlanesIsMadeAgain)
{
  const auto plane = clipObliquely(this->Shown);
  this->mapper()->LightThroughCutsOn();
  this->Shown.render();
  const vtkTypeInt64 before = this->mapper()->GetVertexLightBuilds();
  this->Shown.render();
  EXPECT_EQ(this->mapper()->GetVertexLightBuilds(), before);
  plane->SetOrigin(0.4, 0.4, 0.6);
  this->Shown.render();
  EXPECT_EQ(this->mapper()->GetVertexLightBuilds(), before + 1);
}

// The views of error and cost, too, are of what is left.
TEST_F(ClippingStages, RaysBesideWhatIsLeftCostNothing)
{
  const vtkTypeInt64 rays = this->mapper()->GetNumberOfRays();
  addClippingPlane(this->Shown, { 0.5, 0.5, 0.9 }, { 0.0, 0.0, 1.0 });
  this->Shown.render();
  EXPECT_GT(this->mapper()->GetNumberOfRays(), 100);
  EXPECT_LT(this->mapper()->GetNumberOfRays(), rays);
  EXPECT_GT(this->mapper()->GetNumberOfLookups(), 100);
}

class ClippingErrors : public ErrorScene
{
protected:
  void expectErrorOfPlane(const Vec3& origin, const Vec3& normal, const std::string& words)
  {
    this->expectError([=] { addClippingPlane(this->Shown, origin, normal); },
      [this] { this->Shown.Mapper->RemoveAllClippingPlanes(); }, { words, "vtkPlane::SetNormal" });
  }
};

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

TEST_F(ClippingErrors, PlanesThatAreNone)
{
  this->expectErrorOfPlane({ 0.5, 0.5, 0.5 }, { 0.0, 0.0, 0.0 }, "Clipping plane 0");
  this->expectErrorOfPlane({ 0.5, 0.5, 0.5 }, { NaN, 0.0, 1.0 }, "normal");
  this->expectErrorOfPlane({ NaN, 0.5, 0.5 }, { 0.0, 0.0, 1.0 }, "finite");
  this->expectErrorOfPlane({ 0.5, Infinity, 0.5 }, { 0.0, 1.0, 1.0 }, "finite");
}

TEST_F(ClippingErrors, TooManyPlanes)
{
  const auto add = [this](int count)
  {
    for (int i = 0; i < count; ++i)
    {
      addClippingPlane(this->Shown, { -1.0, -1.0, -1.0 }, { 1.0, 1.0, 0.1 * i });
    }
  };
  const auto removeAll = [this] { this->Shown.Mapper->RemoveAllClippingPlanes(); };
  add(32);
  this->expectSound();
  removeAll();
  this->expectError([&] { add(33); }, removeAll, { "33 clipping planes", "at most 32" });
}

TEST_F(ClippingErrors, CroppingPlaneThatIsNoNumber)
{
  this->expectError(
    [this]
    {
      crop(this->Shown, VTK_CROP_FENCE);
      this->Shown.Mapper->SetCroppingRegionPlanes(0.1, 0.9, 0.1, NaN, 0.1, 0.9);
    },
    [this] { this->Shown.Mapper->CroppingOff(); }, { "not a number", "SetCroppingRegionPlanes" });
}

TEST_F(ClippingErrors, NothingLeftIsNone)
{
  addClippingPlane(this->Shown, { 0.5, 0.5, 0.5 }, { 0.3, 1.0, 0.2 });
  addClippingPlane(this->Shown, { 0.5, 0.45, 0.5 }, { -0.3, -1.0, -0.2 });
  this->expectNothingVisible();
  EXPECT_EQ(this->Shown.Mapper->GetNumberOfRays(), 0);
  this->Shown.Mapper->RemoveAllClippingPlanes();
  this->expectSound();
  crop(this->Shown, 0);
  this->expectNothingVisible();
  EXPECT_EQ(this->Shown.Mapper->GetNumberOfDraws(), 0);
  crop(this->Shown, VTK_CROP_FENCE);
  this->frame();
  this->Shown.Mapper->SetCroppingRegionPlanes(0.1, 0.9, 0.6, 0.5, 0.1, 0.9);
  this->expectNothingVisible();
  EXPECT_EQ(this->Shown.Mapper->GetNumberOfDraws(), 0);
  this->Shown.Mapper->CroppingOff();
  this->expectSound();
}
} // namespace
