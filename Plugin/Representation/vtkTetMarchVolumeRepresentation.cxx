// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchVolumeRepresentation.h"

#include "DrawnData.h"
#include "VolumeInView.h"

#include "vtkAlgorithmOutput.h"
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

// Where the data lies, when it or the blocks to be seen have changed.
int vtkTetMarchVolumeRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0], 0);
  this->InputProblem.lookAt(input);
  if (vtkUnstructuredGrid::SafeDownCast(input) || vtkDataObjectTree::SafeDownCast(input))
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

void vtkTetMarchVolumeRepresentation::OfferData(vtkInformation* inInfo, vtkInformation* outInfo)
{
  using RenderView = vtkPVRenderView;
  RenderView::SetPiece(inInfo, this, this->Drawn);
  RenderView::SetRequiresDistributedRendering(inInfo, this, true);
  vtkNew<vtkMatrix4x4> place;
  this->Actor->GetMatrix(place);
  RenderView::SetGeometryBounds(inInfo, this, this->DataBounds, place);

  if (this->ExactCompositing)
  {
    outInfo->Set(RenderView::RENDER_EMPTY_IMAGES(), 1); // each process takes part in each frame
  }
  else
  {
    // Processes draw their volumes one behind the other.
    outInfo->Set(RenderView::NEED_ORDERED_COMPOSITING(), 1);
  }
  RenderView::SetRedistributionModeToUniquelyAssignBoundaryCells(inInfo, this);
  RenderView::SetOrderedCompositingConfiguration(inInfo, this,
    this->ExactCompositing || this->UseDataPartitions
      ? RenderView::USE_BOUNDS_FOR_REDISTRIBUTION
      : RenderView::DATA_IS_REDISTRIBUTABLE | RenderView::USE_DATA_FOR_LOAD_BALANCING);
}

void vtkTetMarchVolumeRepresentation::PrepareToRender(vtkInformation* inInfo)
{
  vtkAlgorithmOutput* producer = inInfo->Has(vtkPVRenderView::USE_LOD())
                                   ? vtkPVRenderView::GetPieceProducerLOD(inInfo, this)
                                   : vtkPVRenderView::GetPieceProducer(inInfo, this);
  vtkDataObject* data = producer ? producer->GetProducer()->GetOutputDataObject(0) : nullptr;
  const bool drawable =
    vtkUnstructuredGrid::SafeDownCast(data) || vtkDataObjectTree::SafeDownCast(data);
  this->TetMarchMapper->SetInputConnection(drawable ? producer : nullptr);
  this->TetMarchMapper->SetController(this->FindPartners(inInfo));
  if (this->WholeBounds.IsValid())
  {
    std::array<double, 6> bounds;
    this->WholeBounds.GetBounds(bounds.data());
    this->TetMarchMapper->SetWholeBounds(bounds.data());
  }
  this->UpdateMapperParameters();
  const char* array = this->TetMarchMapper->GetArrayName();
  const bool visible = this->GetVisibility() && drawable && array && *array;
  this->Actor->SetVisibility(visible);
  this->Legend->SetVisibility(visible);
}

// The processes that draw the frame with this one; null if each draws its piece over the others.
vtkMultiProcessController* vtkTetMarchVolumeRepresentation::FindPartners(
  vtkInformation* inInfo) const
{
  auto* view = vtkPVRenderView::SafeDownCast(inInfo->Get(vtkPVView::VIEW()));
  const bool distributed = view && (inInfo->Has(vtkPVRenderView::USE_LOD())
                                       ? view->GetUseDistributedRenderingForLODRender()
                                       : view->GetUseDistributedRenderingForRender());
  auto* all = vtkMultiProcessController::GetGlobalController();
  const bool alone = all && all->GetNumberOfProcesses() == 1;
  const bool exact = this->ExactCompositing && view && (distributed || alone) &&
                     !view->GetUseOrderedCompositing() && !view->InTileDisplayMode();
  return exact ? all : nullptr;
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
