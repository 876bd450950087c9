// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchVolumeMapper.h"

#include "GL/FrameFigures.h"
#include "GL/Pipeline.h"
#include "Mesh/MeshReport.h"
#include "Scene/AccuracyChoice.h"
#include "Scene/MissingScalars.h"
#include "Scene/ViewColors.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkLookupTable.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTetMarchFrameStatistics.h"
#include "vtkTimerLog.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridBase.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace
{
tetmarch::OpacityLaw lawOf(int opacityLaw)
{
  return opacityLaw == vtkTetMarchVolumeMapper::STRUCTURED ? tetmarch::OpacityLaw::Structured
                                                           : tetmarch::OpacityLaw::Unstructured;
}

const char* nameOf(int accuracyLevel)
{
  constexpr const char* names[] = { "Fast", "Default", "Accurate", "Reference" };
  return names[accuracyLevel];
}

tetmarch::Measure measureOf(int viewMode)
{
  return viewMode == vtkTetMarchVolumeMapper::VIEW_CELLS     ? tetmarch::Measure::Cells
         : viewMode == vtkTetMarchVolumeMapper::VIEW_LOOKUPS ? tetmarch::Measure::Lookups
                                                             : tetmarch::Measure::ErrorBound;
}
} // namespace

class vtkTetMarchVolumeMapper::Internals
{
public:
  tetmarch::Pipeline Pipeline;
  tetmarch::AccuracyChoice Choice;
  std::string LastError; // reported already
  std::string LastReport;
  vtkNew<vtkTetMarchFrameStatistics> Statistics;
  vtkNew<vtkLookupTable> ViewTable;
};

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
  if (!window || !this->GetInput() || renderer->GetSelector())
  {
    return;
  }
  tetmarch::Pipeline& pipeline = this->Internal->Pipeline;
  pipeline.begin(static_cast<std::uint64_t>(this->MaxMemoryInBytes));
  tetmarch::AccuracyChoice& choice = this->Internal->Choice;
  const tetmarch::AccuracyLevel level =
    choice.begin({ static_cast<tetmarch::Accuracy>(this->AccuracyLevel), this->ErrorTolerance,
      this->FrameTimeBudget, this->ErrorBudget });
  this->Internal->Statistics->Clear();
  auto* grid = vtkUnstructuredGrid::SafeDownCast(this->GetInput());
  if (!grid || grid->GetNumberOfCells() == 0)
  {
    this->ReportError(grid ? ""
                           : std::string("The input is a ") + this->GetInput()->GetClassName() +
                               ", but only a vtkUnstructuredGrid can be drawn. vtkAppendFilter "
                               "makes one of any data set.");
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

  const tetmarch::MeasureView view{ measureOf(this->ViewMode), this->AutomaticViewRange,
    { { this->ViewRange[0], this->ViewRange[1] } }, this->Internal->ViewTable };
  const tetmarch::DrawOptions options{ level, this->CollectDiagnostics, this->MaxDrawTimeInSeconds,
    this->ViewMode == VIEW_PICTURE ? nullptr : &view };

  const bool drawn = scalars && pipeline.updateMesh(grid, progress) &&
                     pipeline.updateScalars(grid, scalars, cellScalars == 1) &&
                     pipeline.updateTables(volume->GetProperty(), lawOf(this->OpacityLaw), level) &&
                     pipeline.updateView(renderer, volume) && pipeline.upload(window) &&
                     pipeline.draw(window, renderer, options, progress);
  this->ReportError(
    scalars ? pipeline.error()
            : tetmarch::describeMissingScalars(
                grid, { this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName }));
  this->ReportMesh();

  if (drawn)
  {
    glFinish();
    if (pipeline.numberOfDraws() > 1)
    {
      this->UpdateProgress(1.0);
    }
  }
  timer->StopTimer();
  this->TimeToDraw = timer->GetElapsedTime();
  const double aside = options.View ? 0.0 : pipeline.counted().seconds();
  const double seconds = this->TimeToDraw - aside;
  vtkTetMarchFrameStatistics* statistics = this->Internal->Statistics;
  if (drawn)
  {
    tetmarch::takeMeasures(pipeline.counted(), statistics);
    statistics->SetSeconds(seconds);
    statistics->SetGPUMemoryBytes(this->GetGPUMemoryBytes());
  }
  choice.end({ drawn, !options.View, pipeline.onlyDrew(), seconds,
    statistics->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND), pipeline.subject() });
}

//------------------------------------------------------------------------------
vtkTetMarchFrameStatistics* vtkTetMarchVolumeMapper::GetLastFrameStatistics()
{
  return this->Internal->Statistics;
}

//------------------------------------------------------------------------------
bool vtkTetMarchVolumeMapper::RenderReference(vtkVolume* volume, vtkFloatArray* pixels)
{
  tetmarch::ReferenceImage image;
  if (vtkOpenGLRenderWindow* window = this->Internal->Pipeline.window())
  {
    window->MakeCurrent();
  }
  if (!volume || !this->Internal->Pipeline.renderReference(
                   volume->GetProperty(), lawOf(this->OpacityLaw), image))
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
bool vtkTetMarchVolumeMapper::CompareWithReference(vtkVolume* volume)
{
  const tetmarch::Diagnostics& counted = this->Internal->Pipeline.counted();
  if (counted.measures().empty())
  {
    vtkErrorMacro("There is no frame to compare: switch CollectDiagnostics on and render first.");
    return false;
  }
  vtkNew<vtkFloatArray> reference;
  if (!this->RenderReference(volume, reference))
  {
    return false;
  }
  tetmarch::takeTrueErrors(counted, reference, this->Internal->Statistics);
  return true;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkTetMarchVolumeMapper::FindScalars(vtkUnstructuredGrid* grid, int& cellFlag)
{
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
  const std::string report = tetmarch::describe(this->Internal->Pipeline.mesh().Report);
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

//------------------------------------------------------------------------------
const char* vtkTetMarchVolumeMapper::GetAccuracyLevelAsString() const
{
  return nameOf(this->AccuracyLevel);
}
const char* vtkTetMarchVolumeMapper::GetUsedAccuracyLevelAsString() const
{
  return nameOf(this->GetUsedAccuracyLevel());
}

//------------------------------------------------------------------------------
int vtkTetMarchVolumeMapper::GetUsedAccuracyLevel() const
{
  return static_cast<int>(this->Internal->Choice.used().Level);
}
double vtkTetMarchVolumeMapper::GetUsedErrorTolerance() const
{
  return this->Internal->Choice.used().Tolerance;
}
bool vtkTetMarchVolumeMapper::IsBudgetKept() const { return this->Internal->Choice.isKept(); }

//------------------------------------------------------------------------------
const char* vtkTetMarchVolumeMapper::GetViewModeAsString() const
{
  constexpr const char* names[] = { "Picture", "ErrorBound", "Cells", "Lookups" };
  return names[this->ViewMode];
}

//------------------------------------------------------------------------------
vtkLookupTable* vtkTetMarchVolumeMapper::GetViewLookupTable() { return this->Internal->ViewTable; }

//------------------------------------------------------------------------------
vtkIdType vtkTetMarchVolumeMapper::GetNumberOfTetrahedra() const
{
  return this->Internal->Pipeline.mesh().numberOfTets();
}

//------------------------------------------------------------------------------
vtkIdType vtkTetMarchVolumeMapper::GetNumberOfBoundaryFaces() const
{
  return static_cast<vtkIdType>(this->Internal->Pipeline.mesh().BoundaryFaces.size());
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTetMarchVolumeMapper::GetGPUMemoryBytes() const
{
  return static_cast<vtkTypeInt64>(this->Internal->Pipeline.gpuBytes());
}

//------------------------------------------------------------------------------
double vtkTetMarchVolumeMapper::GetMeshSeconds() const
{
  return this->Internal->Pipeline.meshRecord().Seconds;
}
double vtkTetMarchVolumeMapper::GetScalarsSeconds() const
{
  return this->Internal->Pipeline.ScalarsRecord.Seconds;
}
double vtkTetMarchVolumeMapper::GetTablesSeconds() const
{
  return this->Internal->Pipeline.TablesRecord.Seconds;
}
double vtkTetMarchVolumeMapper::GetUploadSeconds() const
{
  return this->Internal->Pipeline.UploadRecord.Seconds;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTetMarchVolumeMapper::GetMeshBuilds() const
{
  return this->Internal->Pipeline.meshRecord().Runs;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetScalarsBuilds() const
{
  return this->Internal->Pipeline.ScalarsRecord.Runs;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetTablesBuilds() const
{
  return this->Internal->Pipeline.TablesRecord.Runs;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetUploadedBytes() const
{
  return this->Internal->Pipeline.uploadedBytes();
}

//------------------------------------------------------------------------------
int vtkTetMarchVolumeMapper::GetNumberOfDraws() const
{
  return this->Internal->Pipeline.numberOfDraws();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTetMarchVolumeMapper::GetNumberOfRays() const
{
  return this->Internal->Pipeline.counted().counters().Rays;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetNumberOfCrossedCells() const
{
  return this->Internal->Pipeline.counted().counters().Cells;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetNumberOfEvaluations() const
{
  return this->Internal->Pipeline.counted().counters().Evaluations;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetNumberOfRefusedEntries() const
{
  return this->Internal->Pipeline.counted().counters().Refused;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetNumberOfLostRays() const
{
  return this->Internal->Pipeline.counted().counters().Lost;
}
vtkTypeInt64 vtkTetMarchVolumeMapper::GetNumberOfGuardHits() const
{
  return this->Internal->Pipeline.counted().counters().Guarded;
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::GetDiagnosticPixels(vtkFloatArray* pixels) const
{
  const std::vector<float>& values = this->Internal->Pipeline.counted().pixels();
  pixels->SetNumberOfComponents(4);
  pixels->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / 4));
  std::copy(values.begin(), values.end(), pixels->GetPointer(0));
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OpacityLaw: " << (this->OpacityLaw == STRUCTURED ? "Structured" : "Unstructured")
     << "\n";
  os << indent << "AccuracyLevel: " << this->GetAccuracyLevelAsString() << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "FrameTimeBudget: " << this->FrameTimeBudget << "\n";
  os << indent << "ErrorBudget: " << this->ErrorBudget << "\n";
  os << indent << "UsedAccuracyLevel: " << this->GetUsedAccuracyLevelAsString() << "\n";
  os << indent << "UsedErrorTolerance: " << this->GetUsedErrorTolerance() << "\n";
  os << indent << "BudgetKept: " << (this->IsBudgetKept() ? "Yes" : "No") << "\n";
  os << indent << "MaxDrawTimeInSeconds: " << this->MaxDrawTimeInSeconds << "\n";
  os << indent << "ViewMode: " << this->GetViewModeAsString() << "\n";
  os << indent << "AutomaticViewRange: " << (this->AutomaticViewRange ? "On" : "Off") << "\n";
  os << indent << "ViewRange: " << this->ViewRange[0] << ", " << this->ViewRange[1] << "\n";
  os << indent << "MaxMemoryInBytes: " << this->MaxMemoryInBytes << "\n";
  os << indent << "CollectDiagnostics: " << (this->CollectDiagnostics ? "On" : "Off") << "\n";
  os << indent << "NumberOfTetrahedra: " << this->GetNumberOfTetrahedra() << "\n";
  os << indent << "NumberOfBoundaryFaces: " << this->GetNumberOfBoundaryFaces() << "\n";
  os << indent << "GPUMemoryBytes: " << this->GetGPUMemoryBytes() << "\n";
}
