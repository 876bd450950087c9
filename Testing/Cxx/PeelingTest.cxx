// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Volumes between translucent surfaces, which VTK peels off layer by layer.
#include "CutScene.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
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
    this->Shown->Window->AlphaBitPlanesOn();
    this->Shown->Renderer->SetBackground(0.2, 0.4, 0.6);
    this->Shown->property()->SetScalarOpacityUnitDistance(0.6);
  }

  void peel(bool on)
  {
    this->Shown->Renderer->SetUseDepthPeeling(on);
    this->Shown->Renderer->SetUseDepthPeelingForVolumes(on);
    this->Shown->Renderer->SetMaximumNumberOfPeels(20);
    this->Shown->Renderer->SetOcclusionRatio(0.0);
  }

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
