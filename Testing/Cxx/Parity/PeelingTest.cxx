// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Volumes between translucent surfaces, which VTK peels off layer by layer.
#include "BlendScene.h"
#include "ComponentScene.h"
#include "CutScene.h"
#include "GapScene.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkPointData.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>
#include <iostream>
#include <memory>

namespace
{
using namespace tetmarch::testing;

// A plane through the cube, seen from above.
struct Layer
{
  double Height;
  std::array<double, 3> Colour;
  double Opacity;
};

class Peeling : public testing::Test
{
protected:
  Peeling() { this->use(jitteredLattice(8, 0.15, 1, sineField())); }

  void use(vtkUnstructuredGrid* grid)
  {
    this->Shown = std::make_unique<Scene>(grid);
    prepare(*this->Shown);
    this->Shown->property()->SetScalarOpacityUnitDistance(0.6);
  }

  static void prepare(Scene& scene)
  {
    scene.Window->AlphaBitPlanesOn();
    scene.Renderer->SetBackground(0.2, 0.4, 0.6);
  }

  static void peel(Scene& scene, bool on)
  {
    scene.Renderer->SetUseDepthPeeling(on);
    scene.Renderer->SetUseDepthPeelingForVolumes(on);
    scene.Renderer->SetMaximumNumberOfPeels(20);
    scene.Renderer->SetOcclusionRatio(0.0);
  }
  void peel(bool on) { peel(*this->Shown, on); }

  static vtkSmartPointer<vtkActor> planeOf(const Layer& layer, double opacity)
  {
    auto plane = makePlane(layer.Height, 0.2, layer.Colour);
    plane->GetProperty()->SetOpacity(opacity);
    return plane;
  }

  // What of the volume is seen before an opaque surface in a layer's place, and where that is.
  Image volumeBefore(const Layer& layer, Mask& covered);
  Image expected(const std::vector<Layer>& layers);
  void expectPeeled(const std::vector<Layer>& layers);

  std::unique_ptr<Scene> Shown;
};

Image Peeling::volumeBefore(const Layer& layer, Mask& covered)
{
  Scene& scene = *this->Shown;
  const auto plane = planeOf(layer, 1.0);
  scene.Renderer->AddActor(plane);
  const Image before = scene.render();
  scene.Volume->VisibilityOff();
  scene.Window->Render();
  const float background[] = { 0.2f, 0.4f, 0.6f };
  covered = differsFrom(scene.frame(), background, 0.05f);
  scene.Volume->VisibilityOn();
  scene.Renderer->RemoveActor(plane);
  return before;
}

// In front of each layer the volume adds what it has before this one and hadn't before the last.
Image Peeling::expected(const std::vector<Layer>& layers)
{
  this->peel(false);
  Scene& scene = *this->Shown;
  std::vector<Image> before;
  std::vector<Mask> covered(layers.size());
  for (std::size_t k = 0; k < layers.size(); ++k)
  {
    before.push_back(this->volumeBefore(layers[k], covered[k]));
  }
  const Image all = scene.render();
  double background[3];
  scene.Renderer->GetBackground(background);
  Image result(all.Width, all.Height);
  for (std::size_t p = 0; p < covered[0].size(); ++p)
  {
    const float* last = nullptr;
    float seen = 1.0f; // through the surfaces so far
    const auto addVolume = [&](const Image& upTo)
    {
      const float* here = &upTo.Rgba[4 * p];
      for (int c = 0; c < 3; ++c)
      {
        result.Rgba[4 * p + c] += seen * (here[c] - (last ? last[c] : 0.0f));
      }
      last = here;
    };
    for (std::size_t k = 0; k < layers.size(); ++k)
    {
      if (covered[k][p])
      {
        addVolume(before[k]);
        const auto opacity = static_cast<float>(layers[k].Opacity);
        for (int c = 0; c < 3; ++c)
        {
          result.Rgba[4 * p + c] +=
            seen * (1.0f - last[3]) * opacity * static_cast<float>(layers[k].Colour[c]);
        }
        seen *= 1.0f - opacity;
      }
    }
    if (seen > 0.0f)
    {
      addVolume(all);
    }
    for (int c = 0; c < 3; ++c)
    {
      result.Rgba[4 * p + c] += seen * (1.0f - last[3]) * static_cast<float>(background[c]);
    }
  }
  return result;
}

// Each peel is rounded to bytes, before and after what is behind it has been blended in.
void expectSame(const Image& found, const Image& expected, std::size_t peels)
{
  const double bound = (1.5 + static_cast<double>(peels)) / 255.0;
  const Difference difference = compare(found, expected, {}, bound, Channels::Rgb);
  std::cout << "[ MEASURED ] " << difference.text() << '\n';
  EXPECT_LE(difference.Max, bound) << difference.text();
}

void Peeling::expectPeeled(const std::vector<Layer>& layers)
{
  const Image picture = this->expected(layers);
  std::vector<vtkSmartPointer<vtkActor>> planes;
  for (const Layer& layer : layers)
  {
    planes.push_back(planeOf(layer, layer.Opacity));
    this->Shown->Renderer->AddActor(planes.back());
  }
  this->peel(true);
  this->Shown->Window->Render();
  expectSame(this->Shown->frame(), picture, layers.size());
  EXPECT_EQ(this->Shown->Mapper->GetNumberOfRays(), 0);
  for (const auto& plane : planes)
  {
    this->Shown->Renderer->RemoveActor(plane);
  }
}

// The camera of the scene looks down on them.
const Layer Top{ 0.8, { { 0.9, 0.1, 0.1 } }, 0.4 };
const Layer Middle{ 0.5, { { 0.1, 0.9, 0.3 } }, 0.5 };
const Layer Low{ 0.25, { { 0.2, 0.2, 1.0 } }, 0.3 };
const Layer Floor{ -0.1, { { 1.0, 1.0, 0.0 } }, 1.0 };

TEST_F(Peeling, OneSurface) { this->expectPeeled({ Middle }); }

TEST_F(Peeling, SurfacesBeforeAndBehind)
{
  this->expectPeeled({ { 1.2, { { 0.9, 0.1, 0.1 } }, 0.4 } });
  this->expectPeeled({ { -0.2, { { 0.9, 0.1, 0.1 } }, 0.4 } });
}

TEST_F(Peeling, ThreeSurfaces) { this->expectPeeled({ Top, Middle, Low }); }

TEST_F(Peeling, BeforeOpaqueGeometry)
{
  this->expectPeeled({ Top, Low, Floor });
  this->expectPeeled({ Top, { 0.5, { { 0.1, 0.9, 0.3 } }, 1.0 } });
}

TEST_F(Peeling, CellScalars)
{
  this->Shown->drawCellScalars();
  this->expectPeeled({ Top, Low });
}

TEST_F(Peeling, ClippedAndCropped)
{
  clipObliquely(*this->Shown);
  this->expectPeeled({ Top, Middle, Low });
  crop(*this->Shown, VTK_CROP_FENCE);
  this->expectPeeled({ Top, Middle, Low });
}

TEST_F(Peeling, CameraInside)
{
  this->Shown->camera()->SetPosition(0.4, 0.45, 0.95);
  this->Shown->camera()->SetFocalPoint(0.55, 0.5, 0.0);
  this->Shown->camera()->SetViewUp(0.0, 1.0, 0.0);
  this->Shown->camera()->SetClippingRange(0.02, 3.0);
  this->expectPeeled({ Top, Low });
}

TEST_F(Peeling, ParallelProjection)
{
  this->Shown->camera()->ParallelProjectionOn();
  this->Shown->camera()->SetParallelScale(0.9);
  this->expectPeeled({ Top, Low });
}

TEST_F(Peeling, MeshWithAHole)
{
  this->use(latticeWithHole(9, 0.15, 1, sineField()));
  this->expectPeeled({ Top, Middle, Low });
}

TEST_F(Peeling, InLight)
{
  this->Shown->property()->ShadeOn();
  vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(3.0, 4.0, 5.0);
  this->Shown->Renderer->AddLight(sun);
  for (const int method :
    { vtkTetMarchVolumeMapper::SHADOWS_OFF, vtkTetMarchVolumeMapper::SHADOWS_AT_VERTICES })
  {
    this->Shown->Mapper->SetShadowMethod(method);
    // Planes have no light of their own: makePlane().
    this->expectPeeled({ Top, Low });
  }
}

// Independent components are drawn without light.
void drawMix(BlendScene& scene, const Mix& mix)
{
  withComponents(scene.Data, wavyFields(mix.Components), VTK_DOUBLE);
  drawComponents(scene, mix);
  scene.property()->SetShade(!mix.Independent);
}

// Whatever is drawn of the volume, before and behind a surface it is what a clipping plane in the
// surface's place leaves of it.
TEST_F(Peeling, PartsAreThoseThatAPlaneCutsOff)
{
  struct Kind
  {
    const char* Name;
    void (*Set)(BlendScene& scene);
  };
  const Kind kinds[] = {
    { "maximum", [](BlendScene& s) { s.Mapper->SetBlendModeToMaximumIntensity(); } },
    { "minimum", [](BlendScene& s) { s.Mapper->SetBlendModeToMinimumIntensity(); } },
    { "average", [](BlendScene& s) { s.Mapper->SetBlendModeToAverageIntensity(); } },
    { "additive", [](BlendScene& s) { s.Mapper->SetBlendModeToAdditive(); } },
    { "surfaces", [](BlendScene& s) { s.Mapper->SetBlendModeToIsoSurface(); } },
    { "gradient opacity, shadows, occlusion and scattering",
      [](BlendScene& s)
      {
        s.addGradientOpacity();
        s.Mapper->SetShadowMethodToAtVertices();
        s.Mapper->AmbientOcclusionOn();
        s.Mapper->SetVolumetricScatteringBlending(1.3f);
      } },
    { "shadows along rays", [](BlendScene& s) { s.Mapper->SetShadowMethodToAlongRays(); } },
    { "shadows of a headlight",
      [](BlendScene& s)
      {
        s.Sun->SetLightTypeToHeadlight();
        s.Mapper->SetShadowMethodToAutomatic();
      } },
    { "what is not finite, and hidden cells",
      [](BlendScene& s)
      {
        breakSome(s.Data->GetPointData()->GetScalars());
        hide(s.Data, isCrumb);
        s.Mapper->DrawNanCellsOn();
      } },
    { "independent components", [](BlendScene& s) { drawMix(s, Mixes[0]); } },
    { "colour and opacity", [](BlendScene& s) { drawMix(s, Mixes[3]); } },
    { "direct colour", [](BlendScene& s) { drawMix(s, Mixes[4]); } },
  };
  for (const Kind& kind : kinds)
  {
    SCOPED_TRACE(kind.Name);
    BlendScene scene(jitteredLattice(6, 0.15, 1, sineField()), 96, 96);
    prepare(scene);
    kind.Set(scene);
    const auto cut = addClippingPlane(scene, { 0.0, 0.0, Middle.Height }, { 0.0, 0.0, 1.0 });
    const Image before = scene.render();
    cut->SetNormal(0.0, 0.0, -1.0);
    const Image behind = scene.render();
    scene.Mapper->RemoveAllClippingPlanes();

    const auto plane = planeOf(Middle, Middle.Opacity);
    scene.Renderer->AddActor(plane);
    peel(scene, true);
    scene.Volume->VisibilityOff();
    scene.Window->Render();
    const float background[] = { 0.2f, 0.4f, 0.6f };
    const Image surface = scene.frame(); // blended over the background
    const Mask covered = differsFrom(surface, background, 0.05f);
    scene.Volume->VisibilityOn();
    scene.Window->Render();

    Image expected(before.Width, before.Height);
    const auto opacity = static_cast<float>(Middle.Opacity);
    for (std::size_t p = 0; p < covered.size(); ++p)
    {
      const float* front = &before.Rgba[4 * p];
      const float* back = &behind.Rgba[4 * p];
      for (int c = 0; c < 3; ++c)
      {
        const float rest = back[c] + (1.0f - back[3]) * background[c];
        const float behindFront =
          opacity * static_cast<float>(Middle.Colour[c]) + (1.0f - opacity) * rest;
        expected.Rgba[4 * p + c] = front[c] + (1.0f - front[3]) * behindFront;
      }
    }
    // Beside the surface a ray is one part.
    const double bound = 2.5 / 255.0;
    const Difference difference = compare(scene.frame(), expected, covered, bound, Channels::Rgb);
    std::cout << "[ MEASURED ] " << kind.Name << ": " << difference.text() << '\n';
    EXPECT_GT(difference.Pixels, 1000u);
    EXPECT_LE(100 * difference.Over, difference.Pixels) << difference.text();
    EXPECT_LE(difference.Rms, 0.8 / 255.0) << difference.text();
  }
}

// Without translucent geometry, or where it alone is peeled, the volume is drawn at once.
TEST_F(Peeling, NothingToPeel)
{
  Scene& scene = *this->Shown;
  const Image picture = scene.render();
  const Image plain = scene.frame();
  this->peel(true);
  scene.Window->Render();
  expectSame(scene.frame(), plain, 1);
  scene.Renderer->AddActor(planeOf(Low, 0.5));
  scene.Renderer->UseDepthPeelingForVolumesOff();
  expectSame(scene.render(), picture, 0);
}

TEST_F(Peeling, AViewportBesideAnother)
{
  Scene& scene = *this->Shown;
  scene.Window->SetSize(2 * SceneSize, SceneSize);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.0, 0.0, 0.5, 1.0);
  scene.Window->AddRenderer(other);
  scene.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  scene.Renderer->AddActor(planeOf(Middle, 0.5));
  this->peel(true);
  scene.Window->Render();
  const Image beside = cropped(scene.frame(), SceneSize, 0, SceneSize, SceneSize);
  scene.Window->RemoveRenderer(other);
  scene.Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
  scene.Window->SetSize(SceneSize, SceneSize);
  scene.Window->Render();
  expectSame(beside, scene.frame(), 0);
}

// The next frame is as if nothing had been, and a second one with peels compiles nothing.
TEST_F(Peeling, LeavesNothingBehind)
{
  Scene& scene = *this->Shown;
  const Image before = scene.render();
  const auto plane = planeOf(Middle, 0.5);
  scene.Renderer->AddActor(plane);
  this->peel(true);
  scene.Window->Render();
  const Image peeled = scene.frame();
  const vtkTypeInt64 bytes = scene.Mapper->GetGPUMemoryBytes();
  scene.Window->Render();
  EXPECT_EQ(compare(peeled, scene.frame()).Max, 0.0);
  EXPECT_EQ(scene.Mapper->GetGPUMemoryBytes(), bytes);
  EXPECT_EQ(scene.Mapper->GetMeshBuilds(), 1);
  EXPECT_EQ(scene.Mapper->GetTablesBuilds(), 1);
  scene.Renderer->RemoveActor(plane);
  this->peel(false);
  EXPECT_EQ(compare(before, scene.render()).Max, 0.0);
}
} // namespace
