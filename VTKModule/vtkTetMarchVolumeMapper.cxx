// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchVolumeMapperInternals.h"

#include "Blocks/MissingScalars.h"
#include "Mapper/FrameOptions.h"
#include "Mesh/MeshReport.h"
#include "Picking/SelectedCells.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkTetMarchFrameMeasures.h"
#include "vtkTimerLog.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace
{
tetmarch::ScalarSelection selectionOf(vtkTetMarchVolumeMapper* mapper)
{
  return { mapper->GetScalarMode(), mapper->GetArrayAccessMode(), mapper->GetArrayId(),
    mapper->GetArrayName() };
}

tetmarch::VectorOptions vectorOptionsOf(vtkTetMarchVolumeMapper* mapper)
{
  return { static_cast<tetmarch::VectorMode>(mapper->GetVectorMode()),
    mapper->GetVectorComponent() };
}

tetmarch::BlendOptions blendOptionsOf(vtkTetMarchVolumeMapper* mapper)
{
  const double* range = mapper->GetAverageIPScalarRange();
  return { mapper->GetBlendMode(), { { range[0], range[1] } } };
}

tetmarch::ClippingOptions clippingOptionsOf(vtkTetMarchVolumeMapper* mapper)
{
  tetmarch::ClippingOptions options;
  options.Planes = mapper->GetClippingPlanes();
  options.Cropping = mapper->GetCropping();
  mapper->GetCroppingRegionPlanes(options.CroppingPlanes.data());
  options.CroppingFlags = mapper->GetCroppingRegionFlags();
  return options;
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
  this->vtkTetMarchVolumeMapper::ReleaseGraphicsResources(this->Internal->Pipeline.window());
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
  this->Internal->begin(selector != nullptr);
  std::string error;
  if (vtkUnstructuredGrid* grid = this->FindGrid(error))
  {
    error = this->RenderGrid(grid, window, renderer, volume);
  }
  this->Internal->recordStatistics();
  this->ReportOnce(error);
  this->ReportWarnings();
}

//------------------------------------------------------------------------------
std::string vtkTetMarchVolumeMapper::RenderGrid(vtkUnstructuredGrid* grid,
  vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* volume)
{
  vtkNew<vtkTimerLog> timer;
  timer->StartTimer();

  int cellScalars = 0;
  vtkDataArray* scalars = this->FindScalars(grid, cellScalars);
  const auto progress = [this, window](double share)
  {
    this->UpdateProgress(share);
    return !window->CheckAbortStatus();
  };

  tetmarch::Pipeline& pipeline = this->Internal->Pipeline;
  const tetmarch::AccuracyLevel& level = this->Internal->Level;
  const tetmarch::BlendOptions blend = blendOptionsOf(this);
  const tetmarch::PeelHooks hooks(volume, this);
  tetmarch::FrameOptions options(this->GetSettings(), static_cast<tetmarch::BlendMode>(blend.Mode),
    renderer, level, hooks, this->Internal->ViewTable);
  options.chooseSampleDistance(
    this->GetSettings(), this->Internal->Distance, volume->GetAllocatedRenderTime());
  vtkVolumeProperty* property = volume->GetProperty();
  const bool drawn =
    scalars && pipeline.updateGeometry(grid, progress) &&
    pipeline.updateScalars(grid, scalars, cellScalars == 1, vectorOptionsOf(this), property) &&
    pipeline.updateBlending(property, blend) &&
    pipeline.updateTables(property, options.Law, level, options.DrawNanCells) &&
    pipeline.updateEffects(renderer, volume, options.Effects) &&
    pipeline.updateView(renderer, volume) &&
    pipeline.updateClipping(volume, clippingOptionsOf(this)) && pipeline.upload(window) &&
    (renderer->GetSelector() ? this->Internal->select(renderer, volume, options.Draw, progress)
                             : pipeline.draw(window, renderer, options.Draw, progress));
  if (!renderer->GetSelector())
  {
    if (drawn)
    {
      pipeline.finish();
      if (pipeline.numberOfDraws() > 1)
      {
        this->UpdateProgress(1.0);
      }
    }
    timer->StopTimer();
    this->TimeToDraw = timer->GetElapsedTime();
    this->Internal->end(options, drawn, this->TimeToDraw);
  }
  return scalars ? pipeline.error() : tetmarch::describeMissingScalars(grid, selectionOf(this));
}

//------------------------------------------------------------------------------
double* vtkTetMarchVolumeMapper::GetBounds()
{
  auto* blocks = vtkCompositeDataSet::SafeDownCast(this->GetDataObjectInput());
  if (!blocks)
  {
    return this->Superclass::GetBounds();
  }
  this->Update();
  tetmarch::boundBlocks(blocks, this->Bounds);
  return this->Bounds;
}

//------------------------------------------------------------------------------
int vtkTetMarchVolumeMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  this->Superclass::FillInputPortInformation(port, info);
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  return 1;
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::SetSettings(vtkTetMarchSettings* settings)
{
  this->Internal->Settings.set(settings);
}
vtkTetMarchSettings* vtkTetMarchVolumeMapper::GetSettings() const
{
  return this->Internal->Settings.get();
}

//------------------------------------------------------------------------------
vtkTetMarchFrameStatistics* vtkTetMarchVolumeMapper::GetLastFrameStatistics() const
{
  this->Internal->recordStatistics();
  return this->Internal->Statistics;
}

//------------------------------------------------------------------------------
vtkLookupTable* vtkTetMarchVolumeMapper::GetViewLookupTable() { return this->Internal->ViewTable; }

//------------------------------------------------------------------------------
vtkUnstructuredGrid* vtkTetMarchVolumeMapper::FindGrid(std::string& error)
{
  vtkDataObject* input = this->GetDataObjectInput();
  auto* grid = vtkUnstructuredGrid::SafeDownCast(input);
  tetmarch::JoinedBlocks& blocks = this->Internal->Blocks;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    error = blocks.update(composite, selectionOf(this));
    grid = blocks.grid();
  }
  else
  {
    blocks.clear();
    error = grid ? ""
                 : std::string("The input is a ") + input->GetClassName() +
                     ", but only a vtkUnstructuredGrid can be drawn, or blocks. vtkAppendFilter "
                     "makes one of any data set.";
  }
  return grid && grid->GetNumberOfCells() > 0 ? grid : nullptr;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkTetMarchVolumeMapper::FindScalars(vtkUnstructuredGrid* grid, int& cellFlag)
{
  if (grid == this->Internal->Blocks.grid())
  {
    cellFlag = this->Internal->Blocks.hasCellScalars() ? 1 : 0;
    return this->Internal->Blocks.scalars();
  }
  vtkDataArray* scalars = vtkAbstractMapper::GetScalars(
    grid, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
  return cellFlag == 2 || (scalars && scalars->GetNumberOfComponents() < 1) ? nullptr : scalars;
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::ReportOnce(const std::string& error)
{
  if (this->Internal->LastError.changesTo(error))
  {
    vtkErrorMacro(<< error);
  }
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::ReportWarnings()
{
  const std::string& omissions = this->Internal->Blocks.omissions();
  if (this->Internal->LastOmissions.changesTo(omissions))
  {
    vtkWarningMacro(<< omissions);
  }
  const std::string report = tetmarch::describe(this->Internal->Tets.mesh().Report);
  if (this->Internal->LastMeshReport.changesTo(report))
  {
    vtkWarningMacro(<< report);
  }
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  vtkOpenGLRenderWindow* holder = this->Internal->Pipeline.window();
  if (holder && holder == window)
  {
    holder->MakeCurrent();
    this->Internal->Pipeline.release(holder);
  }
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
