// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MonkeyScene.h"

#include "MonkeyGrids.h"

#include "vtkCellData.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>

namespace tetmarch::testing
{
namespace
{
// Of the same length, so that what holds it needn't know.
bool takeValues(vtkDataSetAttributes* to, vtkDataSetAttributes* from)
{
  vtkDataArray* old = to->GetScalars();
  vtkDataArray* values = from->GetScalars();
  if (!old || !values || old->GetDataType() != values->GetDataType() ||
      old->GetNumberOfComponents() != values->GetNumberOfComponents() ||
      old->GetNumberOfTuples() != values->GetNumberOfTuples())
  {
    return false;
  }
  for (vtkIdType i = 0; i < old->GetNumberOfTuples(); ++i)
  {
    old->SetTuple(i, i, values);
  }
  old->Modified();
  return true;
}

vtkMatrix4x4* placementOf(int kind)
{
  static const vtkNew<vtkTransform> transform;
  transform->Identity();
  switch (kind)
  {
    case MonkeyState::Turned:
      transform->RotateWXYZ(35.0, 1.0, 2.0, 0.5);
      break;
    case MonkeyState::Stretched:
      transform->Scale(1.5, 0.7, 1.0);
      break;
    case MonkeyState::Mirrored:
      transform->Scale(-1.0, 1.0, 1.0);
      break;
    case MonkeyState::Flat:
      transform->Scale(1.0, 0.0, 1.0);
      break;
    default:
      break;
  }
  return transform->GetMatrix();
}

bool isSame(vtkMatrix4x4* a, vtkMatrix4x4* b)
{
  return std::equal(a->GetData(), a->GetData() + 16, b->GetData());
}

void setFunctions(vtkVolumeProperty* property, int kind)
{
  switch (kind)
  {
    case MonkeyState::Spiky:
      setSpikyFunctions(property);
      break;
    case MonkeyState::OneColor:
      setPlainFunctions(property, { 0.9, 0.6, 0.2 }, 0.5);
      break;
    case MonkeyState::Invisible:
      setPlainFunctions(property, { 0.9, 0.6, 0.2 }, 0.0);
      break;
    default:
      setBumpyFunctions(property);
      break;
  }
  if (kind == MonkeyState::Gray)
  {
    vtkNew<vtkPiecewiseFunction> gray;
    gray->AddPoint(0.0, 0.1);
    gray->AddPoint(1.0, 1.0);
    property->SetColor(gray);
  }
}

constexpr double EditedScalar = 0.7;
} // namespace

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
  this->Lamp->SetLightTypeToSceneLight();
  this->Lamp->PositionalOn();
  this->Lamp->SetConeAngle(60.0);
  this->Lamp->SetColor(0.4, 0.6, 1.0);
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

void MonkeyScene::showData(const MonkeyState& state, bool inPlace)
{
  const MonkeyState* shown = this->Shown.get();
  const bool sameMesh = shown && shown->Dataset == state.Dataset && shown->Moved == state.Moved;
  if (sameMesh && shown->Step == state.Step)
  {
    return;
  }
  const auto data = makeMonkeyData(state.Dataset, state.Step, state.Moved);
  auto* grid = vtkUnstructuredGrid::SafeDownCast(this->Data);
  auto* next = vtkUnstructuredGrid::SafeDownCast(data);
  if (inPlace && sameMesh && grid && next &&
      takeValues(grid->GetPointData(), next->GetPointData()) &&
      takeValues(grid->GetCellData(), next->GetCellData()))
  {
    return;
  }
  this->Data = data;
  this->Mapper->SetInputDataObject(data);
}

void MonkeyScene::showPlacement(const MonkeyState& state)
{
  // About the middle of the data.
  const Vec3 middle = this->boxOf(this->Mapper->GetBounds()).at({ 0.5, 0.5, 0.5 });
  vtkNew<vtkTransform> transform;
  transform->Translate(middle.data());
  transform->Concatenate(placementOf(state.Placement));
  transform->Translate(-middle[0], -middle[1], -middle[2]);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(transform->GetMatrix());
  if (!this->Volume->GetUserMatrix() || !isSame(matrix, this->Volume->GetUserMatrix()))
  {
    this->Volume->SetUserMatrix(matrix);
  }
}

void MonkeyScene::showProperty(const MonkeyState& state)
{
  vtkVolumeProperty* property = this->Volume->GetProperty();
  if (!this->Shown || this->Shown->Functions != state.Functions)
  {
    setFunctions(property, state.Functions);
  }
  const bool edited = state.Edit > 0 && state.Functions != MonkeyState::Invisible;
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  if (edited)
  {
    opacity->AddPoint(EditedScalar, 0.2 * state.Edit);
  }
  else
  {
    opacity->RemovePoint(EditedScalar);
  }
  property->SetScalarOpacityUnitDistance(state.UnitDistance);
  property->SetShade(state.Shade);
  property->SetAmbient(state.Ambient);
  property->SetSpecular(state.Specular);
  property->SetDisableGradientOpacity(!state.GradientOpacity);
  vtkContourValues* values = property->GetIsoSurfaceValues();
  values->SetNumberOfContours(state.IsoValues);
  for (int i = 0; i < state.IsoValues; ++i)
  {
    values->SetValue(i, (i + 0.7) / state.IsoValues);
  }
}

void MonkeyScene::showMapper(const MonkeyState& state)
{
  auto* mapper = this->Mapper.Get();
  const bool ofCells = state.Array == MonkeyState::OfCells;
  mapper->SetScalarMode(
    ofCells ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  mapper->SelectScalarArray(state.Array == MonkeyState::Absent ? "absent" : ofCells ? "c" : "f");
  mapper->SetVectorMode(state.VectorMode);
  mapper->SetVectorComponent(state.VectorComponent);
  mapper->SetBlendMode(state.BlendMode);
  mapper->SetOpacityLaw(state.OpacityLaw);
  mapper->SetAverageIPScalarRange(state.AverageLow, 1e30);
  mapper->SetDrawNanCells(state.DrawNan);
  mapper->SetAccuracyLevel(state.Accuracy);
  mapper->SetErrorTolerance(state.Tolerance);
  mapper->SetFrameTimeBudget(state.FrameTimeBudget);
  mapper->SetErrorBudget(state.ErrorBudget);
  mapper->SetMaxDrawTimeInSeconds(state.MaxDrawTime);
  mapper->SetCollectDiagnostics(state.Diagnostics);
  mapper->SetViewMode(state.ViewMode);
  mapper->SetAutomaticViewRange(state.AutomaticRange);
  mapper->SetViewRange(state.RangeLow, 50.0);
  mapper->SetGradientType(state.GradientType);
  mapper->SetShadowMethod(state.Shadows);
  mapper->SetOpaqueShadows(state.OpaqueShadows);
  mapper->SetVolumetricScatteringBlending(state.Scattering);
  mapper->SetGlobalIlluminationReach(state.Reach);
  mapper->SetAmbientOcclusion(state.Occlusion);
  mapper->SetAmbientOcclusionDirections(state.Directions);
  mapper->SetLightTimeBudget(state.LightTimeBudget);
  mapper->SetAutoAdjustSampleDistances(state.AutoDistance);
  mapper->SetImageSampleDistance(state.SampleDistance);
  mapper->SetMaxMemoryInBytes(state.MaxMemory);
  mapper->SetPickOpacityThreshold(state.PickOpacity);
}

void MonkeyScene::showCuts(const MonkeyState& state)
{
  const Box world = this->boxOf(this->Volume->GetBounds());
  while (this->Planes.size() > state.Planes.size())
  {
    this->Mapper->RemoveClippingPlane(this->Planes.back());
    this->Planes.pop_back();
  }
  for (std::size_t i = 0; i < state.Planes.size(); ++i)
  {
    const bool isNew = i == this->Planes.size();
    if (isNew)
    {
      this->Planes.push_back(vtkSmartPointer<vtkPlane>::New());
    }
    const Vec3 origin = world.at(state.Planes[i].Origin);
    this->Planes[i]->SetOrigin(origin[0], origin[1], origin[2]);
    const Vec3& normal = state.Planes[i].Normal;
    this->Planes[i]->SetNormal(normal[0], normal[1], normal[2]);
    if (isNew)
    {
      this->Mapper->AddClippingPlane(this->Planes[i]);
    }
  }
  const Box data = this->boxOf(this->Mapper->GetBounds());
  const double low = state.CroppingLow;
  const Vec3 from = data.at({ low, low, low });
  const Vec3 to = data.at({ 0.75, 0.75, 0.75 });
  this->Mapper->SetCropping(state.Cropping);
  this->Mapper->SetCroppingRegionPlanes(from[0], to[0], from[1], to[1], from[2], to[2]);
  this->Mapper->SetCroppingRegionFlags(state.CroppingFlags);
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
  place(this->Lamp, { -1.0, 0.5, state.SunPlace });
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
    add(this->Lamp, kind >= MonkeyState::SunAndLamp);
  }
}

void MonkeyScene::showCamera(const MonkeyState& state, vtkCamera* camera, int view)
{
  const Box world = this->boxOf(this->Volume->GetBounds());
  const Vec3 middle = world.at({ 0.5, 0.5, 0.5 });
  const double angle = 1.0 + 1.1 * view;
  Vec3 way{ { std::cos(angle), 0.3 * std::sin(2.0 * angle), std::sin(angle) } };
  const double distance = view == MonkeyState::Inside            ? 0.15
                          : view == MonkeyState::NearPlaneInside ? 0.8
                                                                 : state.Distance;
  const double r = world.Extent;
  camera->SetPosition(middle[0] + distance * r * way[0], middle[1] + distance * r * way[1],
    middle[2] + distance * r * way[2]);
  const double sign = view == MonkeyState::Away ? 2.0 * distance : 0.0;
  camera->SetFocalPoint(
    middle[0] + sign * r * way[0], middle[1] + sign * r * way[1], middle[2] + sign * r * way[2]);
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
