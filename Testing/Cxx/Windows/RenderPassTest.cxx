// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What VTK does to a picture before and after the volume is drawn: a pass may draw into a
// framebuffer of its own, with another camera, other depths or more targets than one. Of each the
// answer is known from the picture without it.
#include "PassScene.h"

#include "vtkActor.h"
#include "vtkCameraPass.h"
#include "vtkDepthPeelingPass.h"
#include "vtkFramebufferPass.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkOverlayPass.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAOPass.h"
#include "vtkSequencePass.h"
#include "vtkTextureObject.h"
#include "vtkTranslucentPass.h"
#include "vtkVolumetricPass.h"

#include <algorithm>

namespace
{
using namespace tetmarch::testing;

class RenderPass : public PassScene
{
};

// The passes of the renderer one by one, with this one for translucent surfaces.
vtkSmartPointer<vtkCameraPass> stepsWith(vtkRenderPass* translucent)
{
  vtkNew<vtkRenderPassCollection> passes;
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  vtkNew<vtkVolumetricPass> volumetric;
  vtkNew<vtkOverlayPass> overlay;
  for (vtkRenderPass* pass :
    std::initializer_list<vtkRenderPass*>{ lights, opaque, translucent, volumetric, overlay })
  {
    passes->AddItem(pass);
  }
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  auto camera = vtkSmartPointer<vtkCameraPass>::New();
  camera->SetDelegatePass(sequence);
  return camera;
}

TEST_F(RenderPass, StepByStep)
{
  this->addBall();
  const Image plain = this->frame();
  vtkNew<vtkTranslucentPass> translucent;
  const auto camera = stepsWith(translucent);
  expectSame(this->frame(camera), plain, 0.0, "sequence");
  vtkNew<vtkRenderStepsPass> steps;
  expectSame(this->frame(steps), plain, 0.0, "steps");
}

TEST_F(RenderPass, IntoAFramebufferOfItsOwn)
{
  this->addBall();
  const Image plain = this->frame();
  for (const int depths :
    { vtkTextureObject::Fixed24, vtkTextureObject::Fixed32, vtkTextureObject::Float32 })
  {
    vtkNew<vtkRenderStepsPass> steps;
    vtkNew<vtkFramebufferPass> pass;
    pass->SetDelegatePass(steps);
    pass->SetColorFormat(vtkTextureObject::Fixed8);
    pass->SetDepthFormat(depths);
    expectSame(this->frame(pass), plain, 1.001 / 255.0, "framebuffer");
    pass->ReleaseGraphicsResources(this->Shown.Window);
  }
}

// Before volumes are drawn: what they are blended over has smooth edges, what hides them has not.
TEST_F(RenderPass, SmoothEdgesOfSurfaces)
{
  const Image alone = this->frame();
  this->Shown.Renderer->UseFXAAOn();
  expectSame(this->frame(), alone, 0.0, "volume alone");
  this->addBall();
  this->Shown.Renderer->UseFXAAOff();
  const Image sharp = frameWithoutVolumes(this->Shown);
  this->Shown.Renderer->UseFXAAOn();
  const Image back = frameWithoutVolumes(this->Shown);
  EXPECT_GT(compare(sharp, back).Max, 0.1);
  const Image picture = this->Shown.render();
  expectSame(this->Shown.frame(), over(picture, back), OneBlend, "before a ball");
}

class Occlusion : public RenderPass
{
protected:
  // White without light, so that what is left of it is what the pass makes of it; a ball on a
  // plane, part of which the volume covers.
  Occlusion()
  {
    this->Shown.Renderer->SetBackground(1.0, 1.0, 1.0);
    for (const auto& surface : { makePlane(0.3, 0.6, { 1.0, 1.0, 1.0 }),
           makeBall({ 0.9, 0.5, 0.45 }, 0.25, { 1.0, 1.0, 1.0 }) })
    {
      // VTK knows normals of what is lit alone.
      surface->GetProperty()->LightingOn();
      surface->GetProperty()->SetAmbient(1.0);
      surface->GetProperty()->SetDiffuse(0.0);
      this->Shown.Renderer->AddActor(surface);
    }
    this->Shown.property()->SetScalarOpacityUnitDistance(2.0);
  }

  static void expectSomeOcclusion(const Image& white)
  {
    const float full[3] = { 1.0f, 1.0f, 1.0f };
    const Mask dark = differsFrom(white, full, 0.1f);
    EXPECT_GT(std::count(dark.begin(), dark.end(), true), 100);
  }
};

// A pass of the renderer, before volumes are drawn.
TEST_F(Occlusion, OfSurfacesBehindAVolume)
{
  this->Shown.Renderer->UseSSAOOn();
  const Image back = frameWithoutVolumes(this->Shown);
  expectSomeOcclusion(back);
  const Image picture = this->Shown.render();
  expectSame(this->Shown.frame(), over(picture, back), OneBlend);
}

// A pass around all steps: it darkens the picture by what surfaces occlude; the volume leaves
// their positions alone.
TEST_F(Occlusion, OfAPassAboutAll)
{
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkSSAOPass> pass;
  pass->SetDelegatePass(steps);
  pass->SetRadius(0.5);
  pass->SetKernelSize(32);
  this->Shown.Renderer->SetPass(pass);
  const Image light = frameWithoutVolumes(this->Shown);
  expectSomeOcclusion(light);
  const Image picture = this->Shown.render();
  const Image frame = this->Shown.frame();
  Image expected(Side, Side);
  for (std::size_t i = 0; i < expected.Rgba.size(); ++i)
  {
    expected.Rgba[i] = (picture.Rgba[i] + 1.0f - picture.Rgba[i | 3]) * light.Rgba[i];
  }
  expectSame(frame, expected, 2.0 / 255.0);
  pass->ReleaseGraphicsResources(this->Shown.Window);
}

// Without peeling, a volume is drawn over all translucent surfaces, wherever they are. So does
// VTK's mapper for images.
TEST_F(RenderPass, TranslucentSurfacesThatAreNotPeeled)
{
  for (const double height : { 1.3, 0.5, -0.3 })
  {
    const auto plane = makePlane(height, 0.2, { 0.9, 0.1, 0.1 });
    plane->GetProperty()->SetOpacity(0.4);
    this->Shown.Renderer->AddActor(plane);
  }
  this->addBall();
  const auto expectOver = [this](const char* what)
  {
    const Image back = frameWithoutVolumes(this->Shown);
    const Image picture = this->Shown.render();
    expectSame(this->Shown.frame(), over(picture, back), OneBlend, what);
  };
  expectOver("by the renderer");
  vtkNew<vtkTranslucentPass> translucent;
  this->Shown.Renderer->SetPass(stepsWith(translucent));
  expectOver("as they come");
  vtkNew<vtkOrderIndependentTranslucentPass> independent;
  independent->SetTranslucentPass(translucent);
  this->Shown.Renderer->SetPass(stepsWith(independent));
  expectOver("independent of their order");
  vtkNew<vtkDepthPeelingPass> peeling;
  peeling->SetTranslucentPass(translucent);
  const auto peeled = stepsWith(peeling);
  this->Shown.Renderer->SetPass(peeled);
  expectOver("surfaces alone peeled");
}
} // namespace
