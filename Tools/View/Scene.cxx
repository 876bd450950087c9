// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "FunctionPoints.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkAutoInit.h"
#include "vtkCamera.h"
#include "vtkContourValues.h"
#include "vtkProperty.h"
#include "vtkTetMarchSettings.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

VTK_MODULE_INIT(vtkRenderingOpenGL2);
VTK_MODULE_INIT(vtkRenderingVolumeOpenGL2);
VTK_MODULE_INIT(vtkRenderingFreeType);
VTK_MODULE_INIT(vtkInteractionStyle);

namespace tetmarch
{

Scene::Scene()
{
  vtkVolumeProperty* property = this->Volume->GetProperty();
  property->SetColor(this->Color);
  property->SetScalarOpacity(this->Opacity);
  property->SetGradientOpacity(this->GradientOpacity);
  this->Renderer->AddLight(this->Light);
  this->Surface->SetMapper(this->SurfaceMapper);
  this->SurfaceMapper->ScalarVisibilityOff();
  this->Surface->GetProperty()->SetColor(0.8, 0.8, 0.8);
  this->Surface->VisibilityOff();
  this->Surface->PickableOff();
  this->Renderer->AddActor(this->Surface);
  this->Renderer->AddViewProp(this->Legend);
  const ViewState state;
  this->Renderer->SetBackground(state.Background.data());
}

std::array<double, 6> Scene::GetBounds() const
{
  std::array<double, 6> bounds;
  const double* of = this->Mapper->GetMapper()->GetBounds();
  std::copy(of, of + 6, bounds.begin());
  return bounds;
}

double Scene::GetDiagonal() const
{
  const auto b = this->GetBounds();
  return std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
}

void Scene::SetMapper(const std::shared_ptr<AnyMapper>& mapper)
{
  this->Mapper = mapper;
  this->Volume->SetMapper(mapper->GetMapper());
  this->Renderer->AddVolume(this->Volume);
  this->Legend->SetMapper(mapper->GetMapper());
}

void Scene::SetData(const Prepared& data, const std::shared_ptr<AnyMapper>& mapper,
  bool functionsChosen, double aspect, ViewState& state)
{
  this->Data = data;
  if (mapper)
  {
    this->SetMapper(mapper);
  }
  else if (!this->Mapper || this->Structured != data.Data.Structured)
  {
    this->SetMapper(MakeMapper(data.Data.Structured));
  }
  this->Structured = data.Data.Structured;
  this->Mapper->SetInput(data.Data.GetMapperInput());

  vtkTetMarchFirstPicture* choice = data.Choice;
  state.Data.Array = choice->GetChosenArray()->GetName();
  state.Data.Association = choice->GetChosenAssociation();
  state.Data.Component = choice->GetChosenComponent();
  state.Data.TimeStep = data.Data.Times.empty() ? -1 : data.Data.TimeStep;
  if (functionsChosen)
  {
    GetFunctions(choice->GetColor(), choice->GetOpacity(), state.Functions);
    state.Functions.UnitDistance = choice->GetUnitDistance();
    state.Functions.StructuredOpacityLaw = this->Structured;
    this->PlaceCamera(aspect);
    const CutState none;
    state.Cuts = none;
    const auto b = this->GetBounds();
    state.Cuts.Origin = { { (b[0] + b[1]) / 2, (b[2] + b[3]) / 2, (b[4] + b[5]) / 2 } };
    state.Cuts.Box = b;
    state.Functions.GradientOpacity = this->MakeGradientOpacity(state.Effects.GradientStrength);
    CameraState& camera = state.Camera;
    vtkCamera* placed = this->Renderer->GetActiveCamera();
    placed->GetPosition(camera.Position.data());
    placed->GetFocalPoint(camera.FocalPoint.data());
    placed->GetViewUp(camera.ViewUp.data());
    camera.ParallelScale = placed->GetParallelScale();
    camera.ViewAngle = placed->GetViewAngle();
  }
}

void Scene::SetSurface(vtkPolyData* surface)
{
  this->SurfaceMapper->SetInputData(surface);
  this->Surface->SetVisibility(surface != nullptr);
}

void Scene::Apply(const ViewState& state)
{
  this->Renderer->SetBackground(state.Background.data());
  this->ApplyLight(state.Effects);
  if (!this->Mapper)
  {
    return;
  }
  this->ApplyProperty(state);
  this->ApplySettings(state);
  this->ApplyCuts(state.Cuts);
  this->ApplyCamera(state.Camera);
}

void Scene::ApplyProperty(const ViewState& state)
{
  vtkVolumeProperty* property = this->Volume->GetProperty();
  FunctionState drawn = state.Functions;
  GetFunctions(this->Color, this->Opacity, drawn);
  const FunctionState& wanted = state.Functions;
  if (drawn.Color != wanted.Color || drawn.Opacity != wanted.Opacity ||
      drawn.ColorSpace != wanted.ColorSpace || drawn.LogScale != wanted.LogScale ||
      drawn.HSVWrap != wanted.HSVWrap || drawn.NanColor != wanted.NanColor)
  {
    SetFunctions(wanted, this->Color, this->Opacity);
  }
  property->SetScalarOpacityUnitDistance(wanted.UnitDistance);
  property->SetInterpolationType(
    state.Data.Nearest ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
  property->SetDisableGradientOpacity(!state.Effects.GradientOpacity);
  if (state.Effects.GradientOpacity)
  {
    SetPoints(wanted.GradientOpacity, this->GradientOpacity);
  }
  vtkContourValues* surfaces = property->GetIsoSurfaceValues();
  surfaces->SetNumberOfContours(static_cast<int>(state.IsoValues.size()));
  for (std::size_t i = 0; i < state.IsoValues.size(); ++i)
  {
    surfaces->SetValue(static_cast<int>(i), state.IsoValues[i]);
  }
}

void Scene::ApplySettings(const ViewState& state)
{
  this->Mapper->SelectArray(state.Data.Association, state.Data.Array);
  this->Mapper->SetComponent(state.Data.Component);
  this->Mapper->SetBlendMode(state.BlendMode);
  vtkTetMarchSettings* settings = this->Mapper->GetSettings();
  if (state.Settings.AccuracyLevel == vtkTetMarchSettings::SAMPLED)
  {
    this->Mapper->SetSamples(-1.0, false);
  }
  else
  {
    this->Mapper->SetSamplesOff();
  }
  settings->SetOpacityLaw(state.Functions.StructuredOpacityLaw ? vtkTetMarchSettings::STRUCTURED
                                                               : vtkTetMarchSettings::UNSTRUCTURED);
  settings->SetVolumetricScatteringBlending(
    state.Effects.Scattering ? static_cast<float>(state.Effects.ScatteringStrength) : 0.0f);
  tetmarch::ApplySettings(state.Settings, settings);
}

void Scene::ApplyLight(const EffectState& effects)
{
  vtkVolumeProperty* property = this->Volume->GetProperty();
  property->SetShade(effects.Shading);
  property->SetAmbient(effects.Ambient);
  property->SetDiffuse(effects.Diffuse);
  property->SetSpecular(effects.Specular);
  property->SetSpecularPower(effects.SpecularPower);
  this->Light->SetIntensity(effects.Shading ? effects.Intensity : 1.0);
  if (effects.Headlight || !effects.Shading)
  {
    this->Light->SetLightTypeToHeadlight();
  }
  else
  {
    this->Light->SetLightTypeToSceneLight();
    this->Light->SetPosition(effects.LightFrom.data());
    this->Light->SetFocalPoint(0.0, 0.0, 0.0);
  }
}

void Scene::ApplyCuts(const CutState& cuts)
{
  vtkAbstractVolumeMapper* mapper = this->Mapper->GetMapper();
  mapper->RemoveAllClippingPlanes();
  if (cuts.Clip)
  {
    this->Plane->SetOrigin(cuts.Origin[0], cuts.Origin[1], cuts.Origin[2]);
    this->Plane->SetNormal(cuts.Normal[0], cuts.Normal[1], cuts.Normal[2]);
    mapper->AddClippingPlane(this->Plane);
  }
  if (cuts.Crop)
  {
    this->Mapper->SetCropping(cuts.Box.data(), VTK_CROP_SUBVOLUME);
  }
  else
  {
    this->Mapper->SetCroppingOff();
  }
}

void Scene::Capture(ViewState& state)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->GetPosition(state.Camera.Position.data());
  camera->GetFocalPoint(state.Camera.FocalPoint.data());
  camera->GetViewUp(state.Camera.ViewUp.data());
  state.Camera.ViewAngle = camera->GetViewAngle();
  state.Camera.Parallel = camera->GetParallelProjection() != 0;
  state.Camera.ParallelScale = camera->GetParallelScale();
  if (this->Mapper)
  {
    GetFunctions(this->Color, this->Opacity, state.Functions);
  }
}

std::vector<std::array<double, 4>> Scene::MakeGradientOpacity(double strength) const
{
  const double* range = this->Data.Choice->GetChosenRange();
  const double width = std::max(range[1] - range[0], 1e-300);
  // All of the range within a tenth of the diagonal is steep.
  const double steep = 10.0 * width / this->GetDiagonal();
  return { { { 0.0, 1.0 - strength, 0.5, 0.0 } }, { { steep, 1.0, 0.5, 0.0 } } };
}

std::vector<double> Scene::MakeIsoValues(int count) const
{
  const double* range = this->Data.Choice->GetChosenRange();
  std::vector<double> values;
  for (int i = 1; i <= count; ++i)
  {
    values.push_back(range[0] + (range[1] - range[0]) * i / (count + 1));
  }
  return values;
}

} // namespace tetmarch
