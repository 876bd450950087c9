// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchImageVolumeRepresentation.h"

#include "DrawnData.h"
#include "VolumeInView.h"

#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOutlineSource.h"
#include "vtkPVRenderView.h"
#include "vtkPolyDataMapper.h"
#include "vtkTetMarchLastFrame.h"
#include "vtkTetMarchLegend.h"
#include "vtkTetMarchSmartVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <functional>

vtkStandardNewMacro(vtkTetMarchImageVolumeRepresentation);

vtkTetMarchImageVolumeRepresentation::vtkTetMarchImageVolumeRepresentation()
{
  // As the other representation: distances between rays go by AutoAdjustSampleDistances alone.
  this->TetMarchMapper->SetInteractiveAdjustSampleDistances(0);
  this->VolumeMapper = this->TetMarchMapper;
  this->Actor = vtkSmartPointer<tetmarch::BlocksVolume>::New();
  this->Actor->SetProperty(this->Property);
  this->Actor->SetMapper(this->TetMarchMapper);
  this->Actor->SetLODMapper(this->OutlineMapper); // where the data is in another process
  this->Legend->SetMapper(this->TetMarchMapper);
}

vtkTetMarchImageVolumeRepresentation::~vtkTetMarchImageVolumeRepresentation() = default;

int vtkTetMarchImageVolumeRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  std::function<void(vtkDataSet*)> change;
  if (this->UseSeparateOpacityArray)
  {
    change = [this](vtkDataSet* block) { this->AppendOpacityComponent(block); };
  }
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0], 0);
  this->InputProblem.lookAt(input);
  const auto drawn = tetmarch::copyToDraw(input, this->Blocks, change);
  if (!drawn)
  {
    this->WholeBounds.Reset();
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  const vtkBoundingBox bounds = tetmarch::boundsOf(drawn);
  vtkMath::UninitializeBounds(this->DataBounds);
  if (bounds.IsValid())
  {
    bounds.GetBounds(this->DataBounds);
  }
  this->WholeBounds = tetmarch::boundsOfAll(bounds);
  this->Cache = drawn;
  this->DataSize = drawn->GetActualMemorySize();
  this->OutlineSource->SetBounds(this->DataBounds);
  this->OutlineSource->Update();
  this->Actor->SetEnableLOD(0);
  return this->vtkVolumeRepresentation::RequestData(request, inputVector, outputVector);
}

int vtkTetMarchImageVolumeRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* type, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(type, inInfo, outInfo))
  {
    return 0;
  }
  if (type == vtkPVView::REQUEST_UPDATE())
  {
    vtkNew<vtkMatrix4x4> place; // which the superclass leaves out
    this->Actor->GetMatrix(place);
    vtkPVRenderView::SetGeometryBounds(inInfo, this, this->DataBounds, place);
    this->InputProblem.warn(this, tetmarch::arrayOf(this->GetInputArrayInformation(0)));
  }
  return 1;
}

void vtkTetMarchImageVolumeRepresentation::UpdateMapperParameters()
{
  const char* array = tetmarch::arrayOf(this->GetInputArrayInformation(0));
  const bool visible = this->GetVisibility() && array && *array;
  this->Legend->SetVisibility(visible);
  if (!visible) // the superclass reads the name
  {
    this->Actor->SetVisibility(false);
    return;
  }
  this->Superclass::UpdateMapperParameters();
  if (this->TetMarchMapper->GetCropping())
  {
    this->TetMarchMapper->SetCroppingRegionPlanes(
      tetmarch::croppingPlanes(this->WholeBounds, this->CroppingOrigin, this->CroppingScale)
        .data());
  }
}

void vtkTetMarchImageVolumeRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->Legend->SetVisibility(visible);
}

bool vtkTetMarchImageVolumeRepresentation::AddToView(vtkView* view)
{
  tetmarch::addLegend(view, this->Legend);
  return this->Superclass::AddToView(view);
}

bool vtkTetMarchImageVolumeRepresentation::RemoveFromView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    renderView->UnRegisterPropForHardwareSelection(this, this->Actor);
  }
  tetmarch::removeLegend(view, this->Legend);
  return this->Superclass::RemoveFromView(view);
}

vtkTetMarchSettings* vtkTetMarchImageVolumeRepresentation::GetSettings() const
{
  return this->TetMarchMapper->GetSettings();
}

void vtkTetMarchImageVolumeRepresentation::SetLastFrame(vtkTetMarchLastFrame* frame)
{
  frame->Follow(this->TetMarchMapper, this->TetMarchMapper->GetLastFrameStatistics());
}

void vtkTetMarchImageVolumeRepresentation::SetAverageIPScalarRange(double low, double high)
{
  this->TetMarchMapper->SetAverageIPScalarRange(low, high);
}

void vtkTetMarchImageVolumeRepresentation::SetCroppingRegionFlags(int flags)
{
  this->TetMarchMapper->SetCroppingRegionFlags(flags);
}

void vtkTetMarchImageVolumeRepresentation::SetSampleDistance(double distance)
{
  this->TetMarchMapper->SetSampleDistance(static_cast<float>(distance));
}

void vtkTetMarchImageVolumeRepresentation::SetUseJittering(bool jitters)
{
  this->TetMarchMapper->SetUseJittering(jitters ? 1 : 0);
}

void vtkTetMarchImageVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TetMarchMapper:\n";
  this->TetMarchMapper->PrintSelf(os, indent.GetNextIndent());
}
