// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchVolumeRepresentation.h"

#include "DrawnData.h"
#include "VolumeInView.h"

#include "vtkDummyController.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h"
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"
#include "vtkTetMarchLegend.h"
#include "vtkTetMarchVolumeMapper.h"
#include "vtkUnstructuredGrid.h"

#include <functional>

namespace
{
// As the default of the property SelectMapper in TetMarch.xml.in.
constexpr const char* MapperName = "Tet marching";
} // namespace

vtkStandardNewMacro(vtkTetMarchVolumeRepresentation);

vtkTetMarchVolumeRepresentation::vtkTetMarchVolumeRepresentation()
{
  this->AddVolumeMapper(MapperName, this->TetMarchMapper);
  this->SetActiveVolumeMapper(MapperName);
  this->Actor = vtkSmartPointer<tetmarch::BlocksVolume>::New();
  this->Actor->SetProperty(this->Property);
  this->Actor->SetMapper(this->TetMarchMapper);
  this->Legend->SetMapper(this->TetMarchMapper);
}

vtkTetMarchVolumeRepresentation::~vtkTetMarchVolumeRepresentation() = default;

int vtkTetMarchVolumeRepresentation::FillInputPortInformation(int port, vtkInformation* info)
{
  this->Superclass::FillInputPortInformation(port, info);
  // InputProblem tells of what isn't drawn.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

// Where the data lies, when it or the blocks to be seen have changed.
int vtkTetMarchVolumeRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0], 0);
  this->InputProblem.lookAt(input);
  if (tetmarch::isDrawnAsMesh(input))
  {
    std::function<void(vtkDataSet*)> change;
    if (this->UseSeparateOpacityArray)
    {
      change = [this](vtkDataSet* block) { this->AppendOpacityComponent(block); };
    }
    this->Drawn = tetmarch::copyToDraw(input, this->Blocks, change);
  }
  else
  {
    this->Drawn = vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
  const vtkBoundingBox bounds = tetmarch::boundsOf(this->Drawn);
  vtkMath::UninitializeBounds(this->DataBounds);
  if (bounds.IsValid())
  {
    bounds.GetBounds(this->DataBounds);
  }
  this->WholeBounds = input ? tetmarch::boundsOfAll(bounds) : bounds;
  this->AgreeOnMoves(input != nullptr);
  return this->vtkVolumeRepresentation::RequestData(request, inputVector, outputVector);
}

int vtkTetMarchVolumeRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* type, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->vtkVolumeRepresentation::ProcessViewRequest(type, inInfo, outInfo))
  {
    return 0;
  }
  if (type == vtkPVView::REQUEST_UPDATE())
  {
    this->OfferData(inInfo, outInfo);
    this->InputProblem.warn(this, tetmarch::arrayOf(this->GetInputArrayInformation(0)));
  }
  else if (type == vtkPVView::REQUEST_UPDATE_LOD())
  {
    vtkPVRenderView::SetPieceLOD(inInfo, this, vtkPVRenderView::GetPiece(inInfo, this));
    vtkPVRenderView::SetRequiresDistributedRenderingLOD(inInfo, this, true);
  }
  else if (type == vtkPVView::REQUEST_RENDER())
  {
    this->PrepareToRender(inInfo);
  }
  return 1;
}

void vtkTetMarchVolumeRepresentation::UpdateMapperParameters()
{
  this->Superclass::UpdateMapperParameters();
  if (!this->TetMarchMapper->GetCropping())
  {
    return;
  }
  // Another process may have read the data that this one draws.
  vtkBoundingBox box = tetmarch::boundsOf(this->TetMarchMapper->GetDataObjectInput());
  auto* controller = vtkMultiProcessController::GetGlobalController();
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    box.AddBox(this->WholeBounds);
  }
  this->TetMarchMapper->SetCroppingRegionPlanes(
    tetmarch::croppingPlanes(box, this->CroppingOrigin, this->CroppingScale).data());
}

void vtkTetMarchVolumeRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->Legend->SetVisibility(visible);
}

bool vtkTetMarchVolumeRepresentation::AddToView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    renderView->RegisterPropForHardwareSelection(this, this->Actor);
  }
  tetmarch::addLegend(view, this->Legend);
  return this->Superclass::AddToView(view);
}

bool vtkTetMarchVolumeRepresentation::RemoveFromView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    renderView->UnRegisterPropForHardwareSelection(this, this->Actor);
  }
  tetmarch::removeLegend(view, this->Legend);
  return this->Superclass::RemoveFromView(view);
}

void vtkTetMarchVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CroppingOrigin: " << this->CroppingOrigin[0] << ", " << this->CroppingOrigin[1]
     << ", " << this->CroppingOrigin[2] << "\n";
  os << indent << "CroppingScale: " << this->CroppingScale[0] << ", " << this->CroppingScale[1]
     << ", " << this->CroppingScale[2] << "\n";
  os << indent << "TetMarchMapper:\n";
  this->TetMarchMapper->PrintSelf(os, indent.GetNextIndent());
}
