// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "vtkCamera.h"

#include <cmath>

namespace tetmarch
{

void Scene::ApplyCamera(const CameraState& state)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(state.Position.data());
  camera->SetFocalPoint(state.FocalPoint.data());
  camera->SetViewUp(state.ViewUp.data());
  camera->SetViewAngle(state.ViewAngle);
  camera->SetParallelProjection(state.Parallel);
  camera->SetParallelScale(state.ParallelScale);
  this->Renderer->ResetCameraClippingRange();
}

void Scene::PlaceCamera(double aspect)
{
  this->Data.Choice->PlaceCamera(this->Renderer->GetActiveCamera(), aspect);
  this->Renderer->ResetCameraClippingRange();
}

void Scene::LookAlong(int axis)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const double* focus = camera->GetFocalPoint();
  const double distance = camera->GetDistance();
  double position[3] = { focus[0], focus[1], focus[2] };
  position[axis] += axis == 1 ? -distance : distance; // the front of what stands upright
  camera->SetPosition(position);
  camera->SetViewUp(0.0, axis == 2 ? 1.0 : 0.0, axis == 2 ? 0.0 : 1.0);
  this->Renderer->ResetCameraClippingRange();
}

void Scene::SwitchProjection()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  // What is at the focal point keeps its size.
  const double half = std::tan(camera->GetViewAngle() * (M_PI / 360.0));
  if (camera->GetParallelProjection())
  {
    const double distance = camera->GetParallelScale() / half;
    const double factor = camera->GetDistance() / distance;
    camera->ParallelProjectionOff();
    camera->Dolly(factor);
  }
  else
  {
    camera->SetParallelScale(camera->GetDistance() * half);
    camera->ParallelProjectionOn();
  }
  this->Renderer->ResetCameraClippingRange();
}

} // namespace tetmarch
