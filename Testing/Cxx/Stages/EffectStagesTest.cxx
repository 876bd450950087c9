// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// An effect of light costs nothing while it is off, and sliders redo only what depends on them.
#include "CpuReference.h"
#include "Held.h"
#include "LitScene.h"

#include <functional>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;
using Mapper = vtkTetMarchVolumeMapper;

constexpr int Side = 96;
constexpr int Cubes = 8;
constexpr vtkTypeInt64 Vertices = (Cubes + 1) * (Cubes + 1) * (Cubes + 1);

// What each thing that effects need takes on the GPU.
constexpr vtkTypeInt64 GradientBytes = 8 * Vertices;
constexpr vtkTypeInt64 CellGradientBytes = 8 * 6 * Cubes * Cubes * Cubes;
constexpr vtkTypeInt64 GradientOpacityBytes = 4 * 1025;
constexpr vtkTypeInt64 VertexLightBytes = vertexLightBytes(Vertices);

Grid lattice() { return jitteredLattice(Cubes, 0.15, 1, sineField()); }

class EffectMemory : public testing::Test
{
protected:
  EffectMemory() { this->Shown.Mapper->CollectDiagnosticsOff(); }

  // Switched on it takes so many bytes more, and none are left when it is off again.
  void expectBytes(const char* what, vtkTypeInt64 bytes, const std::function<void(bool on)>& change)
  {
    SCOPED_TRACE(what);
    this->Shown.Window->Render();
    const Held before(this->Shown);
    change(true);
    this->Shown.Window->Render();
    EXPECT_EQ(this->Shown.Mapper->GetGPUMemoryBytes() - before.Bytes, bytes);
    EXPECT_FALSE(Held(this->Shown) == before);
    change(false);
    this->Shown.Window->Render();
    EXPECT_TRUE(Held(this->Shown) == before);
  }

  Mapper* mapper() { return this->Shown.Mapper; }

  LitScene Shown{ lattice(), Side, Side };
};

// Not even if everything is set but for what would make it visible.
TEST_F(EffectMemory, PlainScenesPayNothing)
{
  const auto drawnPlain = []
  {
    Scene scene(lattice(), Side, Side);
    scene.Mapper->CollectDiagnosticsOff();
    scene.Window->Render();
    return std::pair(Held(scene), countShaders());
  }();
  this->Shown.property()->ShadeOff();
  this->mapper()->SetShadowMethodToAtVertices();
  this->mapper()->SetGradientTypeToCell();
  this->mapper()->AmbientOcclusionOn();
  this->mapper()->SetVolumetricScatteringBlending(1.0f);
  this->Shown.Window->Render();
  EXPECT_TRUE(Held(this->Shown) == drawnPlain.first);
  EXPECT_EQ(countShaders(), drawnPlain.second);
  EXPECT_EQ(this->mapper()->GetGradientsBuilds(), 0);
  EXPECT_EQ(this->mapper()->GetVertexLightBuilds(), 0);
  EXPECT_EQ(this->mapper()->GetGradientsSeconds(), 0.0);
  EXPECT_EQ(this->mapper()->GetVertexLightSeconds(), 0.0);
}

TEST_F(EffectMemory, OfWhatAPictureShows)
{
  vtkVolumeProperty* property = this->Shown.property();
  property->ShadeOff();
  this->expectBytes("shading", GradientBytes, [&](bool on) { property->SetShade(on); });
  this->expectBytes("shading with gradients of cells", CellGradientBytes,
    [&](bool on)
    {
      this->mapper()->SetGradientType(on);
      property->SetShade(on);
    });
  this->expectBytes("directions of gradients", GradientBytes,
    [&](bool on)
    { this->mapper()->SetViewMode(on ? Mapper::VIEW_GRADIENTS : Mapper::VIEW_PICTURE); });
  this->Shown.addGradientOpacity();
  property->DisableGradientOpacityOn();
  this->expectBytes("gradient opacity", GradientBytes + GradientOpacityBytes,
    [&](bool on) { property->SetDisableGradientOpacity(!on); });
  EXPECT_EQ(this->mapper()->GetVertexLightBuilds(), 0);
  EXPECT_EQ(this->mapper()->GetMeshBuilds(), 1);
}

TEST_F(EffectMemory, OfWhatIsAddedToShading)
{
  const auto setMethod = [this](int method)
  {
    return [this, method](bool on)
    { this->mapper()->SetShadowMethod(on ? method : Mapper::SHADOWS_OFF); };
  };
  this->expectBytes(
    "shadows at vertices", VertexLightBytes, setMethod(Mapper::SHADOWS_AT_VERTICES));
  this->expectBytes("shadows along rays", JitterBytes, setMethod(Mapper::SHADOWS_ALONG_RAYS));
  this->expectBytes("scattering", VertexLightBytes,
    [this](bool on) { this->mapper()->SetVolumetricScatteringBlending(on ? 1.5f : 0.0f); });
  this->expectBytes(
    "occlusion", VertexLightBytes, [this](bool on) { this->mapper()->SetAmbientOcclusion(on); });
  this->expectBytes("occlusion and shadows along rays", VertexLightBytes + JitterBytes,
    [&](bool on)
    {
      setMethod(Mapper::SHADOWS_ALONG_RAYS)(on);
      this->mapper()->SetAmbientOcclusion(on);
    });
  EXPECT_EQ(this->mapper()->GetGradientsBuilds(), 1);
  EXPECT_EQ(this->mapper()->GetMeshBuilds(), 1);
}

TEST_F(EffectMemory, HeadlightsNeedNoRays)
{
  this->Shown.Sun->SetLightTypeToHeadlight();
  this->Shown.Window->Render();
  const Held before(this->Shown);
  this->mapper()->SetShadowMethodToAtVertices();
  this->Shown.Window->Render();
  EXPECT_TRUE(Held(this->Shown) == before);
  EXPECT_EQ(this->mapper()->GetVertexLightBuilds(), 0);
}

// The counters of the stages and the shaders, to say by how much they grew.
struct Work
{
  vtkTypeInt64 Scalars = 0; // and the mesh
  vtkTypeInt64 Tables = 0;
  vtkTypeInt64 Gradients = 0;
  vtkTypeInt64 Light = 0;
  vtkTypeInt64 Bytes = 0;
  int Shaders = 0;
};

class EffectSliders : public testing::Test
{
protected:
  EffectSliders()
  {
    this->Shown.addGradientOpacity();
    this->mapper()->SetShadowMethodToAtVertices();
    this->mapper()->AmbientOcclusionOn();
    this->Before = this->Shown.render();
  }

  Mapper* mapper() { return this->Shown.Mapper; }
  vtkVolumeProperty* property() { return this->Shown.property(); }

  Work work()
  {
    return { this->mapper()->GetMeshBuilds() + this->mapper()->GetScalarsBuilds(),
      this->mapper()->GetTablesBuilds(), this->mapper()->GetGradientsBuilds(),
      this->mapper()->GetVertexLightBuilds(), this->mapper()->GetUploadedBytes(), countShaders() };
  }

  // The change is seen, as the reference sees it, after so many runs of the light pass and of the
  // tables, and no others.
  void expectRuns(const char* what, int light, int tables, const std::function<void()>& change,
    double leastChange = 0.01)
  {
    SCOPED_TRACE(what);
    const Work before = this->work();
    change();
    const Image after = this->Shown.render();
    const Work done = this->work();
    EXPECT_EQ(done.Light - before.Light, light);
    EXPECT_EQ(done.Tables - before.Tables, tables);
    EXPECT_EQ(done.Scalars, before.Scalars);
    EXPECT_EQ(done.Gradients, before.Gradients);
    EXPECT_EQ(done.Shaders, before.Shaders);
    EXPECT_GE(compare(this->Before, after).Max, leastChange);
    this->Before = after;
    const Mask inside = regionsOf(this->Shown).Inside;
    EXPECT_LE(compare(after, referenceOf(this->Shown).Picture, inside).Max, 2.0 / 255.0);
  }

  LitScene Shown{ lattice(), Side, Side };
  Image Before;
};

TEST_F(EffectSliders, NothingChangesNothing)
{
  EXPECT_EQ(this->mapper()->GetGradientsBuilds(), 1);
  EXPECT_EQ(this->mapper()->GetVertexLightBuilds(), 1);
  const vtkTypeInt64 bytes = this->mapper()->GetUploadedBytes();
  this->expectRuns(
    "nothing", 0, 0, [] {}, 0.0);
  EXPECT_EQ(this->mapper()->GetUploadedBytes(), bytes);
}

TEST_F(EffectSliders, OfLightAndMaterialOnlyDraw)
{
  const vtkTypeInt64 bytes = this->mapper()->GetUploadedBytes();
  vtkLight* sun = this->Shown.Sun;
  this->expectRuns("intensity", 0, 0, [&] { sun->SetIntensity(0.6); });
  this->expectRuns("colour", 0, 0, [&] { sun->SetDiffuseColor(0.4, 1.0, 0.7); });
  this->expectRuns("ambient colour", 0, 0, [&] { sun->SetAmbientColor(0.3, 0.6, 0.0); });
  this->expectRuns("strength of shadows", 0, 0, [&] { sun->SetShadowAttenuation(0.3f); });
  this->expectRuns("ambient", 0, 0, [&] { this->property()->SetAmbient(0.5); });
  this->expectRuns("diffuse", 0, 0, [&] { this->property()->SetDiffuse(1.0); });
  this->expectRuns("specular", 0, 0, [&] { this->property()->SetSpecular(2.0); });
  this->expectRuns("specular power", 0, 0, [&] { this->property()->SetSpecularPower(3.0); });
  this->expectRuns("sides", 0, 0, [&] { this->Shown.Renderer->TwoSidedLightingOff(); });
  this->expectRuns("camera", 0, 0, [&] { this->Shown.camera()->Azimuth(20.0); });
  EXPECT_EQ(this->mapper()->GetUploadedBytes(), bytes);
}

TEST_F(EffectSliders, OfWhatComesThroughTheVolumeRedoTheLight)
{
  const vtkTypeInt64 bytes = this->mapper()->GetUploadedBytes();
  vtkLight* sun = this->Shown.Sun;
  this->expectRuns("direction", 1, 0, [&] { sun->SetPosition(-3.0, 4.0, 1.5); });
  this->expectRuns(
    "unit distance", 1, 0, [&] { this->property()->SetScalarOpacityUnitDistance(0.4); });
  this->expectRuns("place of the volume", 1, 0, [&] { this->Shown.Volume->RotateY(30.0); });
  this->expectRuns("reach", 1, 0, [&] { this->mapper()->SetGlobalIlluminationReach(0.2f); });
  this->expectRuns(
    "occlusion radius", 1, 0, [&] { this->mapper()->SetAmbientOcclusionRadius(0.5); }, 0.002);
  this->expectRuns(
    "occlusion directions", 1, 0, [&] { this->mapper()->SetAmbientOcclusionDirections(3); }, 0.002);
  EXPECT_EQ(this->mapper()->GetUploadedBytes(), bytes);
  this->expectRuns(
    "transfer function", 1, 1, [&] { this->property()->GetScalarOpacity()->AddPoint(0.8, 0.0); });
  this->expectRuns(
    "gradient opacity", 1, 0, [&] { this->property()->GetGradientOpacity()->AddPoint(2.0, 1.0); });
  // Tables are made for a tolerance, and light is of tables.
  this->expectRuns(
    "tolerance", 1, 1, [&] { this->mapper()->SetErrorTolerance(1e-3); }, 0.0);
}

TEST_F(EffectSliders, CameraLightsMoveWithTheCamera)
{
  this->Shown.Sun->SetLightTypeToCameraLight();
  this->Shown.render();
  this->expectRuns("camera", 1, 0, [&] { this->Shown.camera()->Azimuth(20.0); });
}

TEST_F(EffectSliders, ScatteringIsOneVariant)
{
  this->mapper()->SetVolumetricScatteringBlending(0.4f);
  this->Before = this->Shown.render();
  for (const float blending : { 0.8f, 1.0f, 2.0f })
  {
    this->expectRuns(
      "blending", 0, 0, [&] { this->mapper()->SetVolumetricScatteringBlending(blending); });
  }
}

// Then nothing is kept at vertices.
TEST_F(EffectSliders, AlongRaysOnlyDraw)
{
  this->property()->SetGradientOpacity(nullptr);
  this->mapper()->AmbientOcclusionOff();
  this->mapper()->CollectDiagnosticsOff();
  this->mapper()->SetShadowMethodToAlongRays();
  this->Shown.Window->Render();
  this->Before = this->Shown.frame();
  const Work before = this->work();
  this->Shown.Sun->SetPosition(-3.0, 4.0, 1.5);
  this->mapper()->SetGlobalIlluminationReach(0.2f);
  this->property()->SetScalarOpacityUnitDistance(0.4);
  this->Shown.Window->Render();
  EXPECT_GT(compare(this->Shown.frame(), this->Before).Max, 0.05);
  const Work done = this->work();
  EXPECT_EQ(done.Light, before.Light);
  EXPECT_EQ(done.Bytes, before.Bytes);
  EXPECT_EQ(done.Shaders, before.Shaders);
}
} // namespace
