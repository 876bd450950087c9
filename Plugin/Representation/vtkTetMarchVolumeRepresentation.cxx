// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchVolumeRepresentation.h"

#include "SelectedBlocks.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataAssemblyUtilities.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkInformation.h"
#include "vtkLODProp3D.h"
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

#include <algorithm>
#include <tuple>

namespace
{
// As the default of the property SelectMapper in TetMarch.xml.
constexpr const char* MapperName = "Tet marching";

// ParaView's volume draws nothing whose mapper has no single grid, but blocks have none.
class BlocksVolume : public vtkPVLODVolume
{
public:
  static BlocksVolume* New();
  vtkTypeMacro(BlocksVolume, vtkPVLODVolume);

  int RenderVolumetricGeometry(vtkViewport* viewport) override
  {
    const int drawn = this->LODProp->RenderVolumetricGeometry(viewport);
    this->EstimatedRenderTime = this->LODProp->GetEstimatedRenderTime();
    return drawn;
  }
};
vtkStandardNewMacro(BlocksVolume);

vtkBoundingBox boundsOf(vtkDataObject* data)
{
  double bounds[6];
  vtkMath::UninitializeBounds(bounds);
  if (auto* tree = vtkCompositeDataSet::SafeDownCast(data))
  {
    tree->GetBounds(bounds);
  }
  else if (auto* grid = vtkDataSet::SafeDownCast(data))
  {
    grid->GetBounds(bounds);
  }
  return vtkBoundingBox(bounds);
}

// Around the boxes of all processes; each has to call it.
vtkBoundingBox boundsOfAll(const vtkBoundingBox& box)
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() < 2)
  {
    return box;
  }
  double low[3];
  double high[3];
  box.GetMinPoint(low[0], low[1], low[2]);
  box.GetMaxPoint(high[0], high[1], high[2]);
  double lowest[3];
  double highest[3];
  controller->AllReduce(low, lowest, 3, vtkCommunicator::MIN_OP);
  controller->AllReduce(high, highest, 3, vtkCommunicator::MAX_OP);
  return vtkBoundingBox(lowest[0], highest[0], lowest[1], highest[1], lowest[2], highest[2]);
}

// A copy that shares the arrays, but has its own lists of them.
template <typename Data>
vtkSmartPointer<Data> shallowCopy(Data* data)
{
  auto copy = vtkSmartPointer<Data>::Take(data->NewInstance());
  copy->ShallowCopy(data);
  return copy;
}
} // namespace

vtkStandardNewMacro(vtkTetMarchVolumeRepresentation);

vtkTetMarchVolumeRepresentation::vtkTetMarchVolumeRepresentation()
  : ActiveAssembly(vtkDataAssemblyUtilities::HierarchyName())
{
  this->AddVolumeMapper(MapperName, this->TetMarchMapper);
  this->SetActiveVolumeMapper(MapperName);
  this->Actor = vtkSmartPointer<BlocksVolume>::New();
  this->Actor->SetProperty(this->Property);
  this->Actor->SetMapper(this->TetMarchMapper);
  this->Legend->SetMapper(this->TetMarchMapper);
}

vtkTetMarchVolumeRepresentation::~vtkTetMarchVolumeRepresentation() = default;

void vtkTetMarchVolumeRepresentation::SetActiveAssembly(const char* name)
{
  this->ActiveAssembly = name ? name : "";
  this->MarkModified();
}

void vtkTetMarchVolumeRepresentation::AddBlockSelector(const char* selector)
{
  this->BlockSelectors.insert(selector);
  this->MarkModified();
}

void vtkTetMarchVolumeRepresentation::RemoveAllBlockSelectors()
{
  this->BlockSelectors.clear();
  this->MarkModified();
}

// Where the data lies, when it or the blocks to be seen have changed.
int vtkTetMarchVolumeRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0], 0);
  if (auto* tree = vtkDataObjectTree::SafeDownCast(input))
  {
    auto selected = tetmarch::selectBlocks(tree, this->ActiveAssembly, this->BlockSelectors);
    const auto at = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(selected->NewTreeIterator());
    for (at->InitTraversal(); this->UseSeparateOpacityArray && !at->IsDoneWithTraversal();
         at->GoToNextItem())
    {
      if (auto* block = vtkDataSet::SafeDownCast(at->GetCurrentDataObject()))
      {
        const auto copy = shallowCopy(block);
        this->AppendOpacityComponent(copy);
        selected->SetDataSet(at, copy);
      }
    }
    this->Drawn = selected;
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(input))
  {
    const auto copy = shallowCopy(grid);
    if (this->UseSeparateOpacityArray)
    {
      this->AppendOpacityComponent(copy);
    }
    this->Drawn = copy;
  }
  else
  {
    this->Drawn = vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
  const vtkBoundingBox bounds = boundsOf(this->Drawn);
  vtkMath::UninitializeBounds(this->DataBounds);
  if (bounds.IsValid())
  {
    bounds.GetBounds(this->DataBounds);
  }
  this->WholeBounds = input ? boundsOfAll(bounds) : bounds;
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

  // Processes draw their volumes one behind the other.
  outInfo->Set(RenderView::NEED_ORDERED_COMPOSITING(), 1);
  RenderView::SetRedistributionModeToUniquelyAssignBoundaryCells(inInfo, this);
  RenderView::SetOrderedCompositingConfiguration(inInfo, this,
    this->UseDataPartitions
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
  this->UpdateMapperParameters();
  const char* array = this->TetMarchMapper->GetArrayName();
  const bool visible = this->GetVisibility() && drawable && array && *array;
  this->Actor->SetVisibility(visible);
  this->Legend->SetVisibility(visible);
}

void vtkTetMarchVolumeRepresentation::UpdateMapperParameters()
{
  this->Superclass::UpdateMapperParameters();
  if (!this->TetMarchMapper->GetCropping())
  {
    return;
  }
  // Another process may have read the data that this one draws.
  vtkBoundingBox box = boundsOf(this->TetMarchMapper->GetDataObjectInput());
  auto* controller = vtkMultiProcessController::GetGlobalController();
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    box.AddBox(this->WholeBounds);
  }
  double planes[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double origin = this->CroppingOrigin[axis];
    const double scale = this->CroppingScale[axis]; // may be negative
    std::tie(planes[2 * axis], planes[2 * axis + 1]) = std::minmax(
      { origin + scale * box.GetBound(2 * axis), origin + scale * box.GetBound(2 * axis + 1) });
  }
  this->TetMarchMapper->SetCroppingRegionPlanes(planes);
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
    renderView->RegisterPropForHardwareSelection(this, this->Actor);
  }
  return this->Superclass::AddToView(view);
}

bool vtkTetMarchVolumeRepresentation::RemoveFromView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    renderView->GetNonCompositedRenderer()->RemoveViewProp(this->Legend);
    renderView->UnRegisterPropForHardwareSelection(this, this->Actor);
  }
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
