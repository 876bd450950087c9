// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What of the volume a vtkTetMarchVolumeRepresentation gives to the view, and what it gets to draw.
#include "vtkTetMarchVolumeRepresentation.h"

#include "AppendedData.h"
#include "DrawnData.h"
#include "RegionPlanes.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDummyController.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkPVLODVolume.h"
#include "vtkPVRenderView.h"
#include "vtkPVRenderViewDataDeliveryManager.h"
#include "vtkPlaneCollection.h"
#include "vtkTetMarchLegend.h"
#include "vtkTetMarchVolumeMapper.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace
{

int numberOfProcesses()
{
  auto* all = vtkMultiProcessController::GetGlobalController();
  return all ? all->GetNumberOfProcesses() : 1;
}

// By process; none if the view keeps other data where it lies, and moves cells to that.
std::vector<vtkBoundingBox> regionsOf(vtkPVRenderView* view)
{
  auto* manager = vtkPVRenderViewDataDeliveryManager::SafeDownCast(view->GetDeliveryManager());
  return manager && !manager->GetRawCuts().empty() ? manager->GetCuts()
                                                   : std::vector<vtkBoundingBox>();
}

} // namespace

// Whether cells can be moved between processes. Each process with input calls it.
void vtkTetMarchVolumeRepresentation::AgreeOnMoves(bool hasInput)
{
  this->WhyNotMoved.clear();
  if (!hasInput || this->UseDataPartitions || numberOfProcesses() < 2)
  {
    return;
  }
  const int own[2] = { vtkUnstructuredGrid::SafeDownCast(this->Drawn) ? 0 : 1,
    tetmarch::findsAppendedData() ? 0 : 1 };
  int any[2] = { 0, 0 };
  vtkMultiProcessController::GetGlobalController()->AllReduce(own, any, 2, vtkCommunicator::MAX_OP);
  if (any[0])
  {
    this->WhyNotMoved =
      "ParaView moves cells of an unstructured grid only, not of blocks or of other grids.";
  }
  else if (any[1])
  {
    this->WhyNotMoved =
      "VTK loses the cells that it sends to another process, together with this version of "
      "libexpat. The remedy: " +
      tetmarch::remedyForAppendedData() + ".";
  }
}

bool vtkTetMarchVolumeRepresentation::MovesCells() const
{
  return !this->UseDataPartitions && this->WhyNotMoved.empty() && numberOfProcesses() > 1;
}

void vtkTetMarchVolumeRepresentation::OfferData(vtkInformation* inInfo, vtkInformation* outInfo)
{
  using RenderView = vtkPVRenderView;
  auto* grid = vtkUnstructuredGrid::SafeDownCast(this->Drawn);
  RenderView::SetPiece(
    inInfo, this, grid && this->MovesCells() ? this->Packed.of(grid) : this->Drawn.Get());
  RenderView::SetRequiresDistributedRendering(inInfo, this, true);
  vtkNew<vtkMatrix4x4> place;
  this->Actor->GetMatrix(place);
  RenderView::SetGeometryBounds(inInfo, this, this->DataBounds, place);

  auto* view = RenderView::SafeDownCast(inInfo->Get(vtkPVView::VIEW()));
  if (this->ExactCompositing && !(view && view->InTileDisplayMode()))
  {
    outInfo->Set(RenderView::RENDER_EMPTY_IMAGES(), 1); // each process takes part in each frame
  }
  else
  {
    // Processes draw their volumes one behind the other.
    outInfo->Set(RenderView::NEED_ORDERED_COMPOSITING(), 1);
  }
  // What follows is for ordered compositing, which something translucent in the view may need, too.
  RenderView::SetRedistributionModeToDuplicateBoundaryCells(inInfo, this);
  RenderView::SetOrderedCompositingConfiguration(inInfo, this,
    this->MovesCells()
      ? RenderView::DATA_IS_REDISTRIBUTABLE | RenderView::USE_DATA_FOR_LOAD_BALANCING
      : RenderView::USE_BOUNDS_FOR_REDISTRIBUTION);
}

void vtkTetMarchVolumeRepresentation::PrepareToRender(vtkInformation* inInfo)
{
  auto* view = vtkPVRenderView::SafeDownCast(inInfo->Get(vtkPVView::VIEW()));
  vtkAlgorithmOutput* producer = inInfo->Has(vtkPVRenderView::USE_LOD())
                                   ? vtkPVRenderView::GetPieceProducerLOD(inInfo, this)
                                   : vtkPVRenderView::GetPieceProducer(inInfo, this);
  vtkDataObject* data = producer ? producer->GetProducer()->GetOutputDataObject(0) : nullptr;
  const bool drawable = tetmarch::isDrawnAsMesh(data);
  this->TetMarchMapper->RemoveAllClippingPlanes();
  PieceReport report;
  if (drawable && this->DrawsPieces(view))
  {
    this->TetMarchMapper->SetInputDataObject(this->TakeArrived(data, view));
    report = this->CheckPieces(view);
  }
  else
  {
    this->TetMarchMapper->SetInputConnection(drawable ? producer : nullptr);
  }
  this->TetMarchMapper->SetController(this->FindPartners(inInfo, view));
  if (this->WholeBounds.IsValid())
  {
    std::array<double, 6> bounds;
    this->WholeBounds.GetBounds(bounds.data());
    this->TetMarchMapper->SetWholeBounds(bounds.data());
  }
  this->UpdateMapperParameters();
  const char* array = this->TetMarchMapper->GetArrayName();
  const bool visible = this->GetVisibility() && drawable && report.Drawable && array && *array;
  this->Actor->SetVisibility(visible);
  this->Legend->SetVisibility(visible);
  this->ReportOnce(report.Message);
}

// Whether this process draws its piece over or under those of others.
bool vtkTetMarchVolumeRepresentation::DrawsPieces(vtkPVRenderView* view) const
{
  return view && numberOfProcesses() > 1 && view->GetUseOrderedCompositing();
}

// The processes that draw the frame with this one. One of a piece of its own is alone, but cuts the
// faces of cells as the others do.
vtkMultiProcessController* vtkTetMarchVolumeRepresentation::FindPartners(
  vtkInformation* inInfo, vtkPVRenderView* view)
{
  if (this->DrawsPieces(view))
  {
    return this->Alone;
  }
  const bool distributed = view && (inInfo->Has(vtkPVRenderView::USE_LOD())
                                       ? view->GetUseDistributedRenderingForLODRender()
                                       : view->GetUseDistributedRenderingForRender());
  auto* all = vtkMultiProcessController::GetGlobalController();
  const bool alone = all && all->GetNumberOfProcesses() == 1;
  return this->ExactCompositing && view && (distributed || alone) ? all : nullptr;
}

// The piece of this process, with the planes at which rays end in it.
vtkDataObject* vtkTetMarchVolumeRepresentation::TakeArrived(
  vtkDataObject* delivered, vtkPVRenderView* view)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(delivered);
  if (!grid || !this->MovesCells())
  {
    return delivered;
  }
  const std::vector<vtkBoundingBox> regions = regionsOf(view);
  const int process = vtkMultiProcessController::GetGlobalController()->GetLocalProcessId();
  if (process < static_cast<int>(regions.size()))
  {
    vtkNew<vtkMatrix4x4> place;
    this->Actor->GetMatrix(place);
    vtkNew<vtkPlaneCollection> planes;
    tetmarch::findRegionPlanes(regions, process, place, planes);
    this->TetMarchMapper->SetClippingPlanes(planes);
  }
  return this->Arrived.of(grid);
}

vtkTetMarchVolumeRepresentation::PieceReport vtkTetMarchVolumeRepresentation::CheckPieces(
  vtkPVRenderView* view) const
{
  const int mode = this->TetMarchMapper->GetBlendMode();
  if (mode != vtkTetMarchVolumeMapper::COMPOSITE_BLEND &&
      mode != vtkTetMarchVolumeMapper::ISOSURFACE_BLEND)
  {
    return { false,
      "Pieces of several processes can't be drawn one over the other in the blend mode " +
        std::string(this->TetMarchMapper->GetBlendModeAsString()) +
        ". Choose Composite or Isosurface, or have TetMarchExactCompositing on, without tile "
        "displays and without translucent surfaces in the view." };
  }
  if (!this->UseDataPartitions && !this->WhyNotMoved.empty())
  {
    return { true,
      "Cells were not redistributed: " + this->WhyNotMoved +
        " Pieces are drawn where they lie, in the order of their boxes, which is right only if "
        "these hardly overlap. TetMarchExactCompositing needs no redistribution." };
  }
  if (this->MovesCells() && regionsOf(view).empty())
  {
    return {
      true,
      "Another volume in the view stays where it lies (an image, or TetMarchUseDataPartitions), "
      "and ParaView moves cells into the boxes of its pieces alone. What is in none of them is "
      "not drawn. Switch TetMarchUseDataPartitions on for this volume, too, or off for the other."
    };
  }
  return {};
}

// By process 0, and not again in the next frame.
void vtkTetMarchVolumeRepresentation::ReportOnce(const std::string& message)
{
  auto* all = vtkMultiProcessController::GetGlobalController();
  if (message != this->LastReport && !message.empty() && all && all->GetLocalProcessId() == 0)
  {
    vtkErrorMacro(<< message);
  }
  this->LastReport = message;
}
