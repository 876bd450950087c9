// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The volume of a MonkeyScene: its data, place, property, mapper and what is cut away.
#include "MonkeyGrids.h"
#include "MonkeyScene.h"

#include "vtkCellData.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkTransform.h"

#include <algorithm>

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
  mapper->SetShaderStage(state.ShaderStage);
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
} // namespace tetmarch::testing
