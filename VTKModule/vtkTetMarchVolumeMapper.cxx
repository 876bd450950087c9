// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchVolumeMapperInternals.h"

#include "Input/MadeGrids.h"
#include "Input/SolidCells.h"
#include "Mapper/MapperFrame.h"
#include "Mapper/RecordStatistics.h"
#include "Mesh/MeshReport.h"
#include "Picking/SelectedCells.h"

#include "vtkCompositeDataSet.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"

#include <algorithm>

namespace
{
// Errors are bounded where pixels are counted.
tetmarch::CurvedOptions curvedOptionsOf(vtkTetMarchVolumeMapper* mapper)
{
  return { mapper->GetGeometryTolerance(),
    mapper->GetCollectDiagnostics() || tetmarch::isMeasure(mapper->GetViewMode()) };
}

// Whether cells are joined into a grid, or made for one.
bool isJoined(vtkDataObject* input, double curvedTolerance)
{
  return (curvedTolerance > 0 && vtkUnstructuredGrid::SafeDownCast(input)) ||
         vtkCompositeDataSet::SafeDownCast(input) || vtkStructuredGrid::SafeDownCast(input) ||
         vtkExplicitStructuredGrid::SafeDownCast(input) || tetmarch::isGridMadeOf(input);
}
} // namespace

vtkStandardNewMacro(vtkTetMarchVolumeMapper);

//------------------------------------------------------------------------------
vtkTetMarchVolumeMapper::vtkTetMarchVolumeMapper()
  : Internal(new Internals(this))
{
}

//------------------------------------------------------------------------------
vtkTetMarchVolumeMapper::~vtkTetMarchVolumeMapper()
{
  this->vtkTetMarchVolumeMapper::ReleaseGraphicsResources(this->Internal->OfTets.window());
  this->Internal->OfLeaves.Pipeline.releaseWhereHeld();
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkHardwareSelector* selector = renderer->GetSelector();
  if (!window || !this->GetDataObjectInput() || (selector && !tetmarch::asksForCells(selector)))
  {
    return;
  }
  const vtkOpenGLState::ScopedglActiveTexture unit(window->GetState()); // uploads choose others
  Internals& internal = *this->Internal;
  std::string error =
    tetmarch::guardedPart([&] { return this->RenderInput(window, renderer, volume); });
  const std::string unrecorded = tetmarch::guardedRecords(
    [&]
    {
      internal.recordStatistics();
      internal.LastOmissions.reportWarning(this, internal.Blocks.omissions());
      internal.LastMeshReport.reportWarning(this, tetmarch::describe(internal.Tets.mesh().Report));
    });
  error = error.empty() ? unrecorded : error;
  // Process 0 reports errors of all processes.
  internal.State.LastError.reportError(
    this, internal.Distributed.Processes.rank() == 0 || selector ? error : "");
}

//------------------------------------------------------------------------------
std::string vtkTetMarchVolumeMapper::RenderInput(
  vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* volume)
{
  Internals& internal = *this->Internal;
  const bool selecting = renderer->GetSelector() != nullptr;
  internal.State.begin(selecting);
  const auto mostBytes = static_cast<std::uint64_t>(this->GetMaxMemoryInBytes());
  for (tetmarch::Pipeline* pipeline : { &internal.OfTets, &internal.OfLeaves.Pipeline })
  {
    selecting ? pipeline->beginPick(mostBytes) : pipeline->begin(mostBytes);
  }
  std::string error;
  vtkDataSet* grid = this->FindGrid(error);
  internal.dropOthers(window);
  return grid || internal.isShared() ? this->RenderGrid(grid, error, window, renderer, volume)
                                     : error;
}

//------------------------------------------------------------------------------
std::string vtkTetMarchVolumeMapper::RenderGrid(vtkDataSet* grid, std::string found,
  vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* volume)
{
  Internals& internal = *this->Internal;
  const tetmarch::ScalarSelection selection = tetmarch::selectionOf(this);
  const tetmarch::DrawnData drawn = internal.drawnOf(this, grid, found);
  found = found.empty() && grid && !drawn.Scalars.Array
            ? tetmarch::describeMissingScalars(grid, selection)
            : found;
  const tetmarch::FrameConditions conditions{ tetmarch::isInteractive(window),
    this->GetAutoAdjustSampleDistances() };
  tetmarch::MapperFrame frame(
    { this, window, renderer, volume }, internal.State, drawn.Blend, conditions);
  const bool distributed = internal.isShared() && !renderer->GetSelector();
  internal.Distributed.MostVisitBytes = static_cast<std::uint64_t>(this->MaxVisitMemoryInBytes);
  tetmarch::StageResult result{ found, !grid };
  if (distributed)
  {
    result =
      frame.prepareDistributed(internal.Tets, internal.OfTets, drawn, found, internal.Distributed);
  }
  else if (result.isDone())
  {
    result = frame.prepare(internal.pipeline(), drawn);
  }
  result = result.then([&] { return frame.draw(internal.pipeline(), internal.origins()); });
  const std::string unrecorded = tetmarch::guardedRecords([&] { frame.end(this->TimeToDraw); });
  return result.Error.empty() ? unrecorded : result.Error;
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::Internals::recordStatistics()
{
  tetmarch::recordBlocks(this->Blocks, this->Leaves, this->State.Statistics);
  tetmarch::recordTetrahedra(this->Tets, this->Textures, this->State.Statistics);
  this->drawsLeaves() ? tetmarch::recordStructured({ &this->OfLeaves }, this->State.Statistics)
                      : tetmarch::recordPipeline(this->OfTets, this->State.Statistics);
  tetmarch::recordShared(this->Distributed.Shared, this->State.Statistics);
  tetmarch::recordAccuracy(this->State.Accuracy, this->State.Statistics);
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::Internals::dropOthers(vtkOpenGLRenderWindow* window)
{
  if (!this->drawsLeaves() && !this->OfLeaves.Volume.isEmpty())
  {
    this->OfLeaves.Pipeline.releaseWhereHeld();
    this->OfLeaves.Volume.updateGeometry({}, {}, {});
    window->MakeCurrent();
  }
  if (this->drawsLeaves() && !this->Tets.isEmpty())
  {
    this->OfTets.releaseWhereHeld();
    this->Tets.updateGeometry({ this->NoCells }, {}, {});
    window->MakeCurrent();
  }
}

//------------------------------------------------------------------------------
double* vtkTetMarchVolumeMapper::GetBounds()
{
  return this->Internal->isShared() ? this->Internal->wholeBounds() : this->GetOwnBounds();
}

//------------------------------------------------------------------------------
double* vtkTetMarchVolumeMapper::GetOwnBounds()
{
  vtkDataObject* input = this->GetDataObjectInput();
  const double curvedTolerance = this->GetGeometryTolerance();
  if (!isJoined(input, curvedTolerance))
  {
    return this->Superclass::GetBounds();
  }
  this->Update();
  if (curvedTolerance > 0)
  {
    std::string error; // Render() tells of it
    this->FindGrid(error);
  }
  this->Internal->Blocks.findBounds(input, this->Bounds);
  return this->Bounds;
}

//------------------------------------------------------------------------------
int vtkTetMarchVolumeMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  this->Superclass::FillInputPortInformation(port, info);
  // Without memory of its own: VTK calls it from wherever it needs the ports.
  const auto append = [info](const char* type)
  { info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), type); };
  for (const char* type :
    { "vtkStructuredGrid", "vtkExplicitStructuredGrid", "vtkDataObjectTree", "vtkUniformGridAMR" })
  {
    append(type);
  }
  tetmarch::forEachTypeOfMadeGrids(append);
  return 1;
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::SetSettings(vtkTetMarchSettings* settings)
{
  this->Internal->State.Settings.set(settings);
}
vtkTetMarchSettings* vtkTetMarchVolumeMapper::GetSettings() const
{
  return this->Internal->State.Settings.get();
}

//------------------------------------------------------------------------------
vtkTetMarchFrameStatistics* vtkTetMarchVolumeMapper::GetLastFrameStatistics() const
{
  this->Internal->recordStatistics();
  return this->Internal->State.Statistics;
}

//------------------------------------------------------------------------------
vtkLookupTable* vtkTetMarchVolumeMapper::GetViewLookupTable()
{
  return this->Internal->State.ViewTable;
}

//------------------------------------------------------------------------------
vtkDataSet* vtkTetMarchVolumeMapper::FindGrid(
  std::string& error, const std::function<bool(double)>& progress)
{
  vtkDataObject* input = this->GetDataObjectInput();
  vtkPointSet* grid = vtkUnstructuredGrid::SafeDownCast(input);
  tetmarch::JoinedBlocks& blocks = this->Internal->Blocks;
  tetmarch::LeafGrid& leaves = this->Internal->Leaves;
  if (this->Internal->isShared())
  {
    leaves.clear();
  }
  else
  {
    leaves.update(input, tetmarch::selectionOf(this));
  }
  if (this->Internal->drawsLeaves())
  {
    blocks.clear();
    return leaves.values();
  }
  vtkStructuredGrid* curvilinear =
    this->Internal->isShared() ? nullptr : this->Internal->Explicit.curvilinearOf(input);
  if (curvilinear)
  {
    blocks.clear();
    grid = tetmarch::hasSolidCells(curvilinear) ? curvilinear : nullptr;
  }
  else if (isJoined(input, this->GetGeometryTolerance()))
  {
    error = blocks.update(input, tetmarch::selectionOf(this), curvedOptionsOf(this), progress);
    grid = blocks.grid();
  }
  else
  {
    blocks.clear();
    error = grid ? ""
                 : std::string("The input is a ") + input->GetClassName() +
                     ", but only a vtkUnstructuredGrid, a curvilinear grid or blocks can be drawn. "
                     "vtkAppendFilter makes a vtkUnstructuredGrid of any data set.";
  }
  return grid && grid->GetNumberOfCells() > 0 ? grid : nullptr;
}

//------------------------------------------------------------------------------
bool vtkTetMarchVolumeMapper::Pick(vtkRenderer* renderer, vtkVolume* volume, int x, int y)
{
  std::string error;
  const tetmarch::Pick pick =
    this->Internal->State.Picking.pick(this, renderer, volume, x, y, error);
  this->Report(error);
  std::copy_n(pick.Position.begin(), 3, this->PickedPosition);
  this->PickedScalar = pick.Scalar;
  this->PickedCellId = pick.Cell;
  this->PickedBlock = this->Internal->hasBlocks() ? pick.Block : 0;
  return pick.Hit;
}

//------------------------------------------------------------------------------
bool vtkTetMarchVolumeMapper::Report(const std::string& error)
{
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
  }
  return error.empty();
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->OfTets.releaseIfHeldBy(window);
  this->Internal->OfLeaves.Pipeline.releaseIfHeldBy(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
const char* vtkTetMarchVolumeMapper::GetBlendModeAsString() const
{
  constexpr const char* names[] = { "Composite", "MaximumIntensity", "MinimumIntensity",
    "AverageIntensity", "Additive", "IsoSurface" };
  return this->BlendMode >= COMPOSITE_BLEND && this->BlendMode <= ISOSURFACE_BLEND
           ? names[this->BlendMode]
           : "Unknown";
}

//------------------------------------------------------------------------------
const char* vtkTetMarchVolumeMapper::GetVectorModeAsString() const
{
  constexpr const char* names[] = { "Disabled", "Magnitude", "Component", "AllComponents" };
  return names[this->VectorMode - DISABLED];
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BlendMode: " << this->GetBlendModeAsString() << "\n";
  os << indent << "AverageIPScalarRange: " << this->AverageIPScalarRange[0] << ", "
     << this->AverageIPScalarRange[1] << "\n";
  os << indent << "VectorMode: " << this->GetVectorModeAsString() << "\n";
  os << indent << "VectorComponent: " << this->VectorComponent << "\n";
  os << indent << "Cropping: " << (this->Cropping ? "On" : "Off") << "\n";
  os << indent << "CroppingRegionPlanes:";
  for (double plane : this->CroppingRegionPlanes)
  {
    os << ' ' << plane;
  }
  os << "\n" << indent << "CroppingRegionFlags: " << this->CroppingRegionFlags << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "MaxVisitMemoryInBytes: " << this->MaxVisitMemoryInBytes << "\n";
  os << indent << "PickedPosition: " << this->PickedPosition[0] << ", " << this->PickedPosition[1]
     << ", " << this->PickedPosition[2] << "\n";
  os << indent << "PickedScalar: " << this->PickedScalar << "\n";
  os << indent << "PickedCellId: " << this->PickedCellId << "\n";
  os << indent << "PickedBlock: " << this->PickedBlock << "\n";
  os << indent << "Settings: " << this->GetSettings() << "\n";
  this->GetSettings()->PrintSelf(os, indent.GetNextIndent());
  os << indent << "LastFrameStatistics: " << this->GetLastFrameStatistics() << "\n";
  this->GetLastFrameStatistics()->PrintSelf(os, indent.GetNextIndent());
}
