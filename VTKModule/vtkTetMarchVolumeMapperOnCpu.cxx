// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Methods that run on the CPU: preparation of the mesh, and repetition of the last frame.
#include "vtkTetMarchVolumeMapperInternals.h"

#include "Mapper/AlgorithmProgress.h"
#include "Mapper/GroundTruthPicture.h"
#include "Mapper/TraceTable.h"

#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"

//------------------------------------------------------------------------------
bool vtkTetMarchVolumeMapper::PrepareMesh()
{
  Internals& internal = *this->Internal;
  if (!this->GetDataObjectInput())
  {
    return this->Report("There is no mesh to prepare: the mapper has no input.");
  }
  if (internal.isShared())
  {
    return this->Report("Several processes prepare their pieces together, by Render().");
  }
  int port = 0;
  this->GetInputAlgorithm(0, 0, port)->Update(port); // this one would tell progress of its own
  const tetmarch::Progress progress = tetmarch::beginProgressOf(this);
  std::string error;
  vtkDataSet* grid = this->FindGrid(error, progress);
  if (grid)
  {
    tetmarch::ResourceLimits limits; // what the GL can hold is checked by the frame
    limits.Bytes = static_cast<std::uint64_t>(this->GetMaxMemoryInBytes());
    const tetmarch::DrawnData drawn = internal.drawnOf(this, grid, error);
    error =
      error.empty() ? internal.marched().updateGeometry(drawn.Volume, limits, progress) : error;
  }
  return this->Report(error) && grid && !internal.marched().isEmpty();
}

//------------------------------------------------------------------------------
bool vtkTetMarchVolumeMapper::RenderGroundTruth(
  vtkVolume* volume, vtkFloatArray* pixels, double tolerance)
{
  std::string error;
  const bool done = tetmarch::renderGroundTruth(
    { this->Internal->pipeline(), volume, tetmarch::beginProgressOf(this), tolerance }, pixels,
    error);
  return this->Report(error) && done;
}

//------------------------------------------------------------------------------
bool vtkTetMarchVolumeMapper::CompareWithGroundTruth(vtkVolume* volume)
{
  std::string error;
  const bool done = tetmarch::compareWithGroundTruth(
    { this->Internal->pipeline(), volume, tetmarch::beginProgressOf(this) },
    this->Internal->State.Statistics, error);
  return this->Report(error) && done;
}

//------------------------------------------------------------------------------
void vtkTetMarchVolumeMapper::GetDiagnosticPixels(vtkFloatArray* pixels) const
{
  tetmarch::copyDiagnosticPixels(this->Internal->pipeline(), pixels);
}

//------------------------------------------------------------------------------
bool vtkTetMarchVolumeMapper::TraceRay(
  vtkVolume* volume, int x, int y, int arithmetic, vtkTable* cells)
{
  Internals& internal = *this->Internal;
  return this->Report(tetmarch::traceRay(internal.pipeline(), internal.State,
    { volume, x, y, arithmetic }, internal.origins(), internal.hasBlocks(), cells));
}
