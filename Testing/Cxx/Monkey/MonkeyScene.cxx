// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MonkeyScene.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>

namespace tetmarch::testing
{
MonkeyScene::MonkeyScene(vtkRenderWindow* window)
  : Window(window)
  , Ball(makeBall({ 0.5, 0.45, 0.6 }, 0.3, { 1.0, 0.8, 0.2 }))
  , Layers{ makePlane(0.3, 0.2, { 0.2, 0.9, 0.4 }), makePlane(0.75, 0.1, { 0.9, 0.2, 0.4 }) }
{
  this->Window->AlphaBitPlanesOn();
  this->Volume->SetMapper(this->Mapper);
  vtkVolumeProperty* property = this->Volume->GetProperty();
  property->SetInterpolationTypeToLinear();
  vtkNew<vtkPiecewiseFunction> byGradient;
  byGradient->AddPoint(0.0, 0.1);
  byGradient->AddPoint(3.5, 1.0);
  property->SetGradientOpacity(byGradient);
  for (vtkActor* layer : this->Layers)
  {
    layer->GetProperty()->SetOpacity(0.4);
  }
  for (vtkRenderer* renderer : { this->Renderer.Get(), this->Beside.Get() })
  {
    renderer->AutomaticLightCreationOff();
    renderer->SetMaximumNumberOfPeels(4);
    renderer->SetOcclusionRatio(0.0);
    renderer->AddVolume(this->Volume);
    renderer->AddActor(this->Ball);
    for (vtkActor* layer : this->Layers)
    {
      renderer->AddActor(layer);
    }
  }
  this->Headlight->SetLightTypeToHeadlight();
  this->Sun->SetLightTypeToSceneLight();
  this->LightSource->SetLightTypeToSceneLight();
  this->LightSource->PositionalOn();
  this->LightSource->SetConeAngle(60.0);
  this->LightSource->SetColor(0.4, 0.6, 1.0);
  this->Window->AddRenderer(this->Renderer);
}

MonkeyScene::~MonkeyScene()
{
  this->Window->RemoveRenderer(this->Beside);
  this->Window->RemoveRenderer(this->Renderer);
}

void MonkeyScene::moveTo(vtkRenderWindow* window)
{
  this->Window->RemoveRenderer(this->Beside);
  this->Window->RemoveRenderer(this->Renderer);
  this->Window = window;
  this->Window->AlphaBitPlanesOn();
  this->Window->AddRenderer(this->Renderer);
  if (this->Shown)
  {
    const MonkeyState shown = *this->Shown;
    this->Shown->SecondRenderer = false;
    this->showWindow(shown);
    this->Shown->SecondRenderer = shown.SecondRenderer;
  }
}

Image MonkeyScene::render()
{
  this->Window->Render();
  return framePictureOf(this->Window);
}

Vec3 MonkeyScene::Box::at(const Vec3& p) const
{
  return { this->Low[0] + this->Extent * p[0], this->Low[1] + this->Extent * p[1],
    this->Low[2] + this->Extent * p[2] };
}

MonkeyScene::Box MonkeyScene::boxOf(const double* bounds) const
{
  Box box;
  if (bounds && bounds[0] <= bounds[1])
  {
    box.Low = { { bounds[0], bounds[2], bounds[4] } };
    box.Extent = std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  }
  return box;
}

void MonkeyScene::show(const MonkeyState& state, bool inPlace)
{
  this->showData(state, inPlace);
  this->showPlacement(state);
  this->showProperty(state);
  this->showMapper(state);
  this->showCuts(state);
  this->showActors(state);
  this->showLights(state);
  this->showCamera(state, this->Renderer->GetActiveCamera(), state.View);
  this->showCamera(state, this->Beside->GetActiveCamera(), MonkeyState::Views - 1);
  this->showWindow(state);
  this->Shown = std::make_unique<MonkeyState>(state);
  // VTK 9.1's selectors have the state remember which buffers are bound, and it binds them again
  // when they are long gone with the actors that they belonged to: a GL error of VTK's own.
  this->Window->MakeCurrent();
  if (this->Window->IsCurrent())
  {
    vtkOpenGLRenderWindow::SafeDownCast(this->Window)->GetState()->Reset();
  }
}

void MonkeyScene::showActors(const MonkeyState& state)
{
  const Box world = this->boxOf(this->Volume->GetBounds());
  this->Ball->SetVisibility(state.Ball);
  for (int i = 0; i < 2; ++i)
  {
    this->Layers[i]->SetVisibility(state.Translucent > i);
  }
  for (vtkActor* actor : { this->Ball.Get(), this->Layers[0].Get(), this->Layers[1].Get() })
  {
    actor->SetPosition(world.Low[0], world.Low[1], world.Low[2]);
    actor->SetScale(world.Extent);
  }
  for (vtkRenderer* renderer : { this->Renderer.Get(), this->Beside.Get() })
  {
    renderer->SetUseDepthPeeling(state.Peeling);
    renderer->SetUseDepthPeelingForVolumes(state.PeelsVolume);
    renderer->SetBackground(state.Background, 0.4, 0.6);
    renderer->SetTwoSidedLighting(state.TwoSided);
  }
}

void MonkeyScene::showLights(const MonkeyState& state)
{
  const Box world = this->boxOf(this->Volume->GetBounds());
  const auto place = [&](vtkLight* light, const Vec3& at)
  {
    const Vec3 from = world.at(at);
    const Vec3 to = world.at({ 0.5, 0.5, 0.5 });
    light->SetPosition(from[0], from[1], from[2]);
    light->SetFocalPoint(to[0], to[1], to[2]);
  };
  place(this->Sun, { 3.0, 4.0, state.SunPlace });
  place(this->LightSource, { -1.0, 0.5, state.SunPlace });
  if (this->Shown && this->Shown->Lights == state.Lights)
  {
    return;
  }
  for (vtkRenderer* renderer : { this->Renderer.Get(), this->Beside.Get() })
  {
    renderer->RemoveAllLights();
    const auto add = [&](vtkLight* light, bool on)
    {
      if (on)
      {
        renderer->AddLight(light);
      }
    };
    const int kind = state.Lights;
    add(this->Headlight, kind == MonkeyState::Headlight || kind == MonkeyState::AllLights);
    add(this->Sun, kind >= MonkeyState::Sun);
    add(this->LightSource, kind >= MonkeyState::SunAndPointLight);
  }
}

void MonkeyScene::showCamera(const MonkeyState& state, vtkCamera* camera, int view)
{
  const Box world = this->boxOf(this->Volume->GetBounds());
  const Vec3 middle = world.at({ 0.5, 0.5, 0.5 });
  const double angle = 1.0 + 1.1 * view;
  Vec3 direction{ { std::cos(angle), 0.3 * std::sin(2.0 * angle), std::sin(angle) } };
  const double distance = view == MonkeyState::Inside            ? 0.15
                          : view == MonkeyState::NearPlaneInside ? 0.8
                                                                 : state.Distance;
  const double r = world.Extent;
  camera->SetPosition(middle[0] + distance * r * direction[0],
    middle[1] + distance * r * direction[1], middle[2] + distance * r * direction[2]);
  const double sign = view == MonkeyState::Away ? 2.0 * distance : 0.0;
  camera->SetFocalPoint(middle[0] + sign * r * direction[0], middle[1] + sign * r * direction[1],
    middle[2] + sign * r * direction[2]);
  camera->SetViewUp(0.1, 1.0, 0.0);
  camera->SetParallelProjection(state.Parallel);
  camera->SetParallelScale(0.9 * r);
  const double near = view == MonkeyState::NearPlaneInside ? 0.6
                      : view == MonkeyState::Inside        ? 0.02
                                                           : 0.2;
  camera->SetClippingRange(near * r, 20.0 * r);
}

void MonkeyScene::showWindow(const MonkeyState& state)
{
  this->Window->SetSize(state.width(), MonkeySizes[state.Size].Height);
  this->Window->SetMultiSamples(state.Peeling ? 0 : state.Samples);
  this->Window->SetDesiredUpdateRate(state.UpdateRate);
  const bool had = this->Shown && this->Shown->SecondRenderer;
  this->Renderer->SetViewport(0.0, 0.0, state.SecondRenderer ? 0.5 : 1.0, 1.0);
  this->Beside->SetViewport(0.5, 0.0, 1.0, 1.0);
  if (state.SecondRenderer && !had)
  {
    this->Window->AddRenderer(this->Beside);
  }
  else if (had && !state.SecondRenderer)
  {
    this->Window->RemoveRenderer(this->Beside);
  }
}
} // namespace tetmarch::testing
