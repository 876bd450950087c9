// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The picture as it stands in the window: blended, in viewports, tiles and windows of any kind.
#include "BlendedFrame.h"

#include "vtkOpenGLRenderer.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"

#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

Grid lattice() { return jitteredLattice(8, 0.15, 1, sineField()); }

// The framebuffer of bytes holds what a framebuffer of floats would, but for rounding.
void expectBlended(Scene& scene)
{
  const Image back = frameWithoutVolumes(scene);
  const Image picture = scene.render();
  EXPECT_GT(compare(picture, Image(picture.Width, picture.Height)).Max, 0.3) << "nothing drawn";
  expectSame(scene.frame(), over(picture, back), OneBlend);
}

TEST(Framebuffer, BlendedOverABackground)
{
  for (const int samples : { 0, 8 })
  {
    Scene scene(lattice());
    scene.Window->SetMultiSamples(samples);
    scene.Renderer->SetBackground(0.2, 0.4, 0.6);
    expectBlended(scene);
    scene.Renderer->GradientBackgroundOn();
    scene.Renderer->SetBackground2(1.0, 0.9, 0.1);
    expectBlended(scene);
  }
}

TEST(Framebuffer, BlendedOverOpaqueGeometry)
{
  // Where samples of a pixel have several depths, one of them decides: no multisampling here.
  Scene scene(lattice());
  scene.Renderer->SetBackground(0.2, 0.4, 0.6);
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
  expectBlended(scene);
  scene.camera()->SetPosition(0.31, 0.42, 0.57);
  scene.camera()->SetFocalPoint(1.0, 0.6, 0.4);
  scene.camera()->SetClippingRange(0.01, 5.0);
  expectBlended(scene);
}

// alpha = 1 - exp(-kappa L) where a plane cuts a constant field.
TEST(Framebuffer, APlaneCutsWhereItIs)
{
  for (const bool stencil : { false, true })
  {
    for (const double height : { 0.031, 0.37, 0.5, 0.9 })
    {
      const int samples = height < 0.4 ? 8 : 0;
      Scene scene(jitteredLattice(6, 0.15, 1, constantField(0.5)));
      scene.Window->SetStencilCapable(stencil);
      scene.Window->SetMultiSamples(samples);
      setPlainFunctions(scene.property(), { 1.0, 0.5, 0.25 }, 0.6);
      scene.property()->SetScalarOpacityUnitDistance(0.4);
      scene.camera()->ParallelProjectionOn();
      scene.camera()->SetParallelScale(0.45);
      scene.camera()->SetPosition(0.5, 0.5, 3.0);
      scene.camera()->SetFocalPoint(0.5, 0.5, 0.5);
      scene.camera()->SetViewUp(0.0, 1.0, 0.0);
      scene.camera()->SetClippingRange(1.0, 4.0);
      scene.Renderer->AddActor(makePlane(height, 0.2, { 1.0, 1.0, 1.0 }));
      const double alpha = 1.0 - std::exp(-0.6 / 0.4 * (1.0 - height));
      const Image picture = scene.render();
      Image expected(SceneSize, SceneSize);
      for (std::size_t i = 0; i < expected.Rgba.size(); i += 4)
      {
        const double rgba[4] = { alpha, 0.5 * alpha, 0.25 * alpha, alpha };
        std::copy(rgba, rgba + 4, &expected.Rgba[i]);
      }
      const Difference difference = compare(picture, expected);
      EXPECT_LE(difference.Max, 1e-5) << difference.text();
    }
  }
}

TEST(Framebuffer, GeometryBeforeHidesAndBehindDoesNot)
{
  Scene scene(lattice());
  const Image alone = scene.render();
  const auto behind = makePlane(-0.5, 3.0, { 1.0, 1.0, 1.0 });
  scene.Renderer->AddActor(behind);
  EXPECT_LE(compare(scene.render(), alone).Max, 1e-6);
  scene.Renderer->RemoveActor(behind);
  scene.Renderer->AddActor(makePlane(1.2, 3.0, { 1.0, 1.0, 1.0 }));
  EXPECT_EQ(compare(scene.render(), Image(SceneSize, SceneSize)).Max, 0.0);
  for (const float value : scene.frame().Rgba)
  {
    ASSERT_EQ(value, 1.0f);
  }
}

TEST(Framebuffer, ViewportsAnywhere)
{
  constexpr int Side = 90;
  for (const bool inside : { false, true })
  {
    Scene alone(lattice(), Side, Side);
    alone.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.3, { 1.0, 0.8, 0.2 }));
    alone.Renderer->SetBackground(0.2, 0.4, 0.6);
    if (inside)
    {
      alone.camera()->SetPosition(0.05, 0.42, 0.57);
      alone.camera()->SetFocalPoint(1.0, 0.5, 0.5);
      alone.camera()->SetClippingRange(0.01, 5.0);
    }
    const Image picture = alone.render();
    const Image frame = alone.frame();

    const auto window = makeWindow(2 * Side, 2 * Side);
    std::vector<vtkSmartPointer<vtkTetMarchVolumeMapper>> mappers;
    for (int i = 0; i < 4; ++i)
    {
      vtkNew<vtkRenderer> renderer;
      renderer->SetViewport(0.5 * (i % 2), 0.5 * (i / 2), 0.5 + 0.5 * (i % 2), 0.5 + 0.5 * (i / 2));
      renderer->SetBackground(0.2, 0.4, 0.6);
      renderer->SetActiveCamera(alone.camera());
      renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.3, { 1.0, 0.8, 0.2 }));
      vtkNew<vtkVolume> volume;
      volume->SetProperty(alone.property());
      mappers.push_back(vtkSmartPointer<vtkTetMarchVolumeMapper>::New());
      mappers.back()->SetInputData(alone.Data);
      mappers.back()->CollectDiagnosticsOn();
      volume->SetMapper(mappers.back());
      renderer->AddVolume(volume);
      window->AddRenderer(renderer);
    }
    window->Render();
    const Image all = framePictureOf(window);
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_LE(compare(floatPictureOf(mappers[i], Side, Side), picture).Max, 1e-5);
      // Such small differences may round to another byte, but seldom do.
      const Difference bytes = compare(
        cropped(all, Side * (i % 2), Side * (i / 2), Side, Side), frame, {}, 0.0, Channels::Rgb);
      EXPECT_LE(bytes.Max, 1.001 / 255.0) << bytes.text();
      EXPECT_LE(bytes.Over, 3u) << bytes.text();
    }
  }
}

TEST(Framebuffer, OneMapperInTwoViewports)
{
  Scene scene(lattice(), 200, 100);
  scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  vtkNew<vtkRenderer> right;
  right->SetViewport(0.5, 0.0, 1.0, 1.0);
  right->SetActiveCamera(scene.camera());
  right->AddVolume(scene.Volume);
  scene.Window->AddRenderer(right);
  scene.Window->Render();
  const Image frame = scene.frame();
  expectSame(cropped(frame, 0, 0, 100, 100), cropped(frame, 100, 0, 100, 100), 0.0, "frame");
  EXPECT_EQ(scene.Mapper->GetMeshBuilds(), 1);
}

TEST(Framebuffer, ResizedWindow)
{
  Scene scene(lattice());
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.3, { 1.0, 0.8, 0.2 }));
  scene.render();
  const int sizes[][2] = { { 131, 77 }, { 64, 200 }, { 1, 1 }, { 160, 160 } };
  for (const auto& size : sizes)
  {
    scene.Window->SetSize(size[0], size[1]);
    const Image picture = scene.render();
    Scene fresh(lattice(), size[0], size[1]);
    fresh.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.3, { 1.0, 0.8, 0.2 }));
    EXPECT_EQ(compare(picture, fresh.render()).Max, 0.0);
    expectSame(scene.frame(), fresh.frame(), 0.0, "frame");
  }
}

TEST(Framebuffer, TwoVolumesInOneRenderer)
{
  Scene scene(lattice());
  scene.Renderer->SetBackground(0.2, 0.4, 0.6);
  const Image back = frameWithoutVolumes(scene);
  vtkNew<vtkTetMarchVolumeMapper> mapper;
  mapper->SetInputData(latticeWithHole(6, 0.15, 2, radialField()));
  mapper->CollectDiagnosticsOn();
  vtkNew<vtkVolume> second;
  second->SetMapper(mapper);
  setBumpyFunctions(second->GetProperty());
  second->GetProperty()->SetScalarOpacityUnitDistance(0.5);
  second->SetPosition(0.5, 0.3, 1.1);
  scene.Renderer->AddVolume(second);
  const Image first = scene.render();
  const Image front = floatPictureOf(mapper, SceneSize, SceneSize);
  EXPECT_GT(front.pixel(SceneSize / 2, SceneSize / 2)[3], 0.1f);
  EXPECT_GT(first.pixel(SceneSize / 2, SceneSize / 2)[3], 0.1f);
  // Drawn in the order of their addition.
  expectSame(scene.frame(), over(front, over(first, back)), 2.0 * OneBlend);
}

// This pass draws into a larger framebuffer of its own: sqrt(5) as wide and high as the window.
TEST(Framebuffer, UnderARenderPass)
{
  constexpr int Wide = 178;
  Scene scene(lattice(), 80, 80);
  Scene large(lattice(), Wide, Wide);
  for (Scene* each : { &scene, &large })
  {
    each->Renderer->AddActor(makePlane(0.4, 0.1, { 1.0, 0.8, 0.2 }));
  }
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkSSAAPass> pass;
  pass->SetDelegatePass(steps);
  vtkOpenGLRenderer::SafeDownCast(scene.Renderer)->SetPass(pass);
  scene.Window->Render();
  const Image picture = floatPictureOf(scene.Mapper, Wide, Wide);
  EXPECT_LE(compare(picture, large.render()).Max, 1e-5);
  EXPECT_GT(compare(scene.frame(), Image(80, 80)).Max, 0.3);
  pass->ReleaseGraphicsResources(scene.Window);
}
} // namespace
