// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchVolumeMapperOptions.h"

#include "Blocks/MissingScalars.h"
#include "Diagnostics/ViewColors.h"
#include "Mesh/MeshReport.h"
#include "Picking/SelectedCells.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
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
} // namespace

vtkStandardNewMacro(vtkTetMarchVolumeMapper);

//------------------------------------------------------------------------------
vtkTetMarchVolumeMapper::vtkTetMarchVolumeMapper()
  : Internal(new Internals)
{
  tetmarch::setViewColors(this->Internal->ViewTable);
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
  tetmarch::Pipeline& pipeline = this->Internal->Pipeline;
  tetmarch::AccuracyController& choice = this->Internal->Choice;
  // A selection leaves what is known of the last frame, and takes its tables.
  tetmarch::AccuracyLevel level = choice.used().level();
  if (selector)
  {
    pipeline.beginPick(static_cast<std::uint64_t>(this->MaxMemoryInBytes));
  }
  else
  {
    pipeline.begin(static_cast<std::uint64_t>(this->MaxMemoryInBytes));
    level = choice.begin({ static_cast<tetmarch::Accuracy>(this->AccuracyLevel),
      this->ErrorTolerance, this->FrameTimeBudget, this->ErrorBudget });
    this->Internal->Statistics->Clear();
  }
  vtkUnstructuredGrid* grid = this->FindGrid();
  if (!grid)
  {
    return;
  }
  vtkNew<vtkTimerLog> timer;
  timer->StartTimer();

  int cellScalars = 0;
  vtkDataArray* scalars = this->FindScalars(grid, cellScalars);
  const auto progress = [this, window](double share)
  {
    this->UpdateProgress(share);
    return !window->CheckAbortStatus();
  };

  const tetmarch::PeelHooks hooks(volume, this);
  const Internals::FrameOptions options(this, renderer, volume, level, hooks);
  vtkVolumeProperty* property = volume->GetProperty();
  const bool drawn =
    scalars && pipeline.updateGeometry(grid, progress) &&
    pipeline.updateScalars(grid, scalars, cellScalars == 1, options.Vector, property) &&
    pipeline.updateBlending(property, options.Blend) &&
    pipeline.updateTables(property, options.Law, level, this->DrawNanCells) &&
    pipeline.updateEffects(renderer, volume, options.Effects) &&
    pipeline.updateView(renderer, volume) && pipeline.updateClipping(volume, options.Clipping) &&
    pipeline.upload(window) &&
    (selector ? this->Internal->select(renderer, volume, options.Draw, progress)
              : pipeline.draw(window, renderer, options.Draw, progress));
  this->ReportError(
    scalars ? pipeline.error() : tetmarch::describeMissingScalars(grid, selectionOf(this)));
  this->ReportMesh();
  if (selector)
  {
    return;
  }

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
  const double aside = options.Draw.View ? 0.0 : pipeline.counted().seconds();
  const double seconds = this->TimeToDraw - aside;
  vtkTetMarchFrameStatistics* statistics = this->Internal->Statistics;
  if (drawn)
  {
    tetmarch::takeMeasures(pipeline.counted(), statistics);
    statistics->SetSeconds(seconds);
    statistics->SetGPUMemoryBytes(this->GetGPUMemoryBytes());
  }
  this->Internal->UsedSampleDistance = options.Draw.SampleDistance;
  if (drawn && options.MarchesPicture &&
      (pipeline.onlyDrew() || !this->Internal->Distance.knowsTime()))
  {
    this->Internal->Distance.drawn(options.Draw.SampleDistance, seconds);
  }
  choice.end({ drawn, options.MarchesPicture && options.Draw.SampleDistance == 1,
    pipeline.onlyDrew(), seconds, statistics->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND),
    pipeline.subject() });
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
vtkTetMarchFrameStatistics* vtkTetMarchVolumeMapper::GetLastFrameStatistics()
{
  return this->Internal->Statistics;
}

//------------------------------------------------------------------------------
bool vtkTetMarchVolumeMapper::RenderGroundTruth(vtkVolume* volume, vtkFloatArray* pixels)
{
  tetmarch::ReferenceImage image;
  if (vtkOpenGLRenderWindow* window = this->Internal->Pipeline.window())
  {
    window->MakeCurrent();
  }
  if (!volume || !this->Internal->Pipeline.renderReference(volume->GetProperty(),
                   static_cast<tetmarch::OpacityLaw>(this->OpacityLaw), image))
  {
    vtkErrorMacro("No reference picture: " << (volume ? this->Internal->Pipeline.error()
                                                      : std::string("no volume was given.")));
    return false;
  }
  pixels->SetNumberOfComponents(4);
  pixels->SetNumberOfTuples(static_cast<vtkIdType>(image.Pixels.size() / 4));
  std::copy(image.Pixels.begin(), image.Pixels.end(), pixels->GetPointer(0));
  return true;
}

//------------------------------------------------------------------------------
bool vtkTetMarchVolumeMapper::CompareWithGroundTruth(vtkVolume* volume)
{
  const tetmarch::Diagnostics& counted = this->Internal->Pipeline.counted();
  if (counted.measures().empty())
  {
    vtkErrorMacro("There is no frame to compare: switch CollectDiagnostics on and render first.");
    return false;
  }
  vtkNew<vtkFloatArray> reference;
  if (!this->RenderGroundTruth(volume, reference))
  {
    return false;
  }
  tetmarch::takeTrueErrors(counted, reference, this->Internal->Statistics);
  return true;
}

//------------------------------------------------------------------------------
vtkUnstructuredGrid* vtkTetMarchVolumeMapper::FindGrid()
{
  vtkDataObject* input = this->GetDataObjectInput();
  auto* grid = vtkUnstructuredGrid::SafeDownCast(input);
  tetmarch::JoinedBlocks& blocks = this->Internal->Blocks;
  std::string error;
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
  if (blocks.omissions() != this->Internal->LastOmissions)
  {
    this->Internal->LastOmissions = blocks.omissions();
    if (!blocks.omissions().empty())
    {
      vtkWarningMacro(<< blocks.omissions());
    }
  }
  if (grid && grid->GetNumberOfCells() > 0)
  {
    return grid;
  }
  this->ReportError(error);
  return nullptr;
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
void vtkTetMarchVolumeMapper::ReportError(const std::string& error)
{
  if (error != this->Internal->LastError)
  {
    this->Internal->LastError = error;
    if (!error.empty())
    {
      vtkErrorMacro(<< error);
    }
  }
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::ReportMesh()
{
  const std::string report = tetmarch::describe(this->Internal->Tets.mesh().Report);
  if (report != this->Internal->LastReport)
  {
    this->Internal->LastReport = report;
    if (!report.empty())
    {
      vtkWarningMacro(<< report);
    }
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
