// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchVolumeRepresentation.h"

#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"
#include "vtkTetMarchLegend.h"
#include "vtkTetMarchVolumeMapper.h"
#include "vtkVolumeProperty.h"
#include "vtkVolumeRepresentationPreprocessor.h"

namespace
{
// As the default of the property SelectMapper in TetMarch.xml.
constexpr const char* MapperName = "Tet marching";
} // namespace

vtkStandardNewMacro(vtkTetMarchVolumeRepresentation);

vtkTetMarchVolumeRepresentation::vtkTetMarchVolumeRepresentation()
{
  this->Preprocessor->SetTetrahedraOnly(0);
  this->AddVolumeMapper(MapperName, this->TetMarchMapper);
  this->SetActiveVolumeMapper(MapperName);
  this->Legend->SetMapper(this->TetMarchMapper);
}

vtkTetMarchVolumeRepresentation::~vtkTetMarchVolumeRepresentation() = default;

void vtkTetMarchVolumeRepresentation::SetOpacityLaw(int law)
{
  this->TetMarchMapper->SetOpacityLaw(law);
}

void vtkTetMarchVolumeRepresentation::SetDrawNanCells(bool draw)
{
  this->TetMarchMapper->SetDrawNanCells(draw);
}

void vtkTetMarchVolumeRepresentation::SetAccuracyLevel(int level)
{
  this->TetMarchMapper->SetAccuracyLevel(level);
}

void vtkTetMarchVolumeRepresentation::SetErrorTolerance(double tolerance)
{
  this->TetMarchMapper->SetErrorTolerance(tolerance);
}

void vtkTetMarchVolumeRepresentation::SetFrameTimeBudget(double seconds)
{
  this->TetMarchMapper->SetFrameTimeBudget(seconds);
}

void vtkTetMarchVolumeRepresentation::SetErrorBudget(double error)
{
  this->TetMarchMapper->SetErrorBudget(error);
}

void vtkTetMarchVolumeRepresentation::SetViewMode(int mode)
{
  this->TetMarchMapper->SetViewMode(mode);
}

void vtkTetMarchVolumeRepresentation::SetAutomaticViewRange(bool automatic)
{
  this->TetMarchMapper->SetAutomaticViewRange(automatic);
}

void vtkTetMarchVolumeRepresentation::SetViewRange(double low, double high)
{
  this->TetMarchMapper->SetViewRange(low, high);
}

void vtkTetMarchVolumeRepresentation::SetGradientType(int type)
{
  this->TetMarchMapper->SetGradientType(type);
}

void vtkTetMarchVolumeRepresentation::SetShadowMethod(int method)
{
  this->TetMarchMapper->SetShadowMethod(method);
}

void vtkTetMarchVolumeRepresentation::SetOpaqueShadows(bool shadows)
{
  this->TetMarchMapper->SetOpaqueShadows(shadows);
}

void vtkTetMarchVolumeRepresentation::SetVolumetricScatteringBlending(double blending)
{
  this->TetMarchMapper->SetVolumetricScatteringBlending(static_cast<float>(blending));
}

void vtkTetMarchVolumeRepresentation::SetGlobalIlluminationReach(double reach)
{
  this->TetMarchMapper->SetGlobalIlluminationReach(static_cast<float>(reach));
}

void vtkTetMarchVolumeRepresentation::SetAmbientOcclusion(bool occlusion)
{
  this->TetMarchMapper->SetAmbientOcclusion(occlusion);
}

void vtkTetMarchVolumeRepresentation::SetAmbientOcclusionRadius(double radius)
{
  this->TetMarchMapper->SetAmbientOcclusionRadius(radius);
}

void vtkTetMarchVolumeRepresentation::SetAmbientOcclusionDirections(int directions)
{
  this->TetMarchMapper->SetAmbientOcclusionDirections(directions);
}

void vtkTetMarchVolumeRepresentation::SetShade(bool shade) { this->Property->SetShade(shade); }

void vtkTetMarchVolumeRepresentation::SetAmbient(double ambient)
{
  this->Property->SetAmbient(ambient);
}

void vtkTetMarchVolumeRepresentation::SetDiffuse(double diffuse)
{
  this->Property->SetDiffuse(diffuse);
}

void vtkTetMarchVolumeRepresentation::SetSpecular(double specular)
{
  this->Property->SetSpecular(specular);
}

void vtkTetMarchVolumeRepresentation::SetSpecularPower(double power)
{
  this->Property->SetSpecularPower(power);
}

void vtkTetMarchVolumeRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->Legend->SetVisibility(visible);
}

// Not composited: each process composites its own piece of the volume, but only the one that shows
// the picture may add a legend. It draws after the others.
bool vtkTetMarchVolumeRepresentation::AddToView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    renderView->GetNonCompositedRenderer()->AddViewProp(this->Legend);
  }
  return this->Superclass::AddToView(view);
}

bool vtkTetMarchVolumeRepresentation::RemoveFromView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    renderView->GetNonCompositedRenderer()->RemoveViewProp(this->Legend);
  }
  return this->Superclass::RemoveFromView(view);
}

void vtkTetMarchVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TetMarchMapper:\n";
  this->TetMarchMapper->PrintSelf(os, indent.GetNextIndent());
}
