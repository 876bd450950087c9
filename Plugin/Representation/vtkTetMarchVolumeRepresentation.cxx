// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchVolumeRepresentation.h"

#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"
#include "vtkTetMarchLegend.h"
#include "vtkTetMarchVolumeMapper.h"
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
