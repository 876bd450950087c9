// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/Pipeline.h"

#include "GL/FmaProbe.h"

#include "vtkCellArray.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPoints.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <chrono>
#include <cstring>

namespace tetmarch
{
namespace
{

// Adds a run of a stage to its record when the scope ends.
class Recorder
{
public:
  explicit Recorder(StageRecord& record)
    : Record(record)
    , Begin(std::chrono::steady_clock::now())
  {
  }
  ~Recorder()
  {
    this->Record.Seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Begin).count();
    ++this->Record.Runs;
  }
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

private:
  StageRecord& Record;
  std::chrono::steady_clock::time_point Begin;
};

// Identity and time of change of an object, which may be null.
void add(std::vector<std::uintptr_t>& fingerprint, vtkObject* object)
{
  fingerprint.push_back(reinterpret_cast<std::uintptr_t>(object));
  fingerprint.push_back(object ? static_cast<std::uintptr_t>(object->GetMTime()) : 0);
}

void add(std::vector<std::uintptr_t>& fingerprint, double value)
{
  std::uintptr_t bits = 0;
  std::memcpy(&bits, &value, sizeof(value));
  fingerprint.push_back(bits);
}

} // namespace

bool Pipeline::fail(const std::string& error)
{
  this->Error = error;
  return false;
}

bool Pipeline::updateMesh(vtkUnstructuredGrid* grid, const Progress& progress)
{
  this->Error.clear();
  Fingerprint input;
  add(input, grid->GetPoints());
  add(input, grid->GetCells());
  add(input, grid->GetCellTypesArray());
  add(input, grid->GetFaces());
  if (input == this->MeshInput)
  {
    return !this->Mesh.Tets.empty();
  }
  this->MeshInput.clear();
  this->ScalarsInput.clear();
  this->LinksOnGpu = this->ScalarsOnGpu = false;

  Recorder recorder(this->MeshRecord);
  std::string error;
  const BuildStatus status = buildTetMesh(grid, progress, this->Mesh, error);
  if (status != BuildStatus::Done)
  {
    this->Mesh = {};
    return this->fail(error);
  }
  this->MeshInput = input;
  return !this->Mesh.Tets.empty();
}

bool Pipeline::updateScalars(vtkUnstructuredGrid* grid, vtkDataArray* array, bool cellScalars)
{
  const std::string wrong = cellScalars
                              ? checkScalars(array, grid->GetNumberOfCells(), "cells")
                              : checkScalars(array, grid->GetNumberOfPoints(), "points");
  if (!wrong.empty())
  {
    return this->fail(wrong);
  }
  Fingerprint input;
  add(input, array);
  input.push_back(cellScalars ? 1 : 0);
  if (input == this->ScalarsInput)
  {
    return true;
  }
  Recorder recorder(this->ScalarsRecord);
  this->CellScalars.clear();
  this->Range = cellScalars ? makeCellScalars(array, this->Mesh, this->CellScalars)
                            : setPointScalars(grid, array, this->Mesh);
  this->ScalarsInput = input;
  this->ScalarsOnGpu = false;
  return true;
}

bool Pipeline::updateTables(vtkVolumeProperty* property, OpacityLaw law)
{
  Fingerprint input;
  add(input, property->GetScalarOpacity());
  add(input, property->GetColorChannels() == 1
               ? static_cast<vtkObject*>(property->GetGrayTransferFunction())
               : property->GetRGBTransferFunction());
  input.push_back(static_cast<std::uintptr_t>(law));
  add(input, this->Range.Low);
  add(input, this->Range.High);
  if (input != this->TablesInput)
  {
    Recorder recorder(this->TablesRecord);
    const SampledFunctions functions = sampleFunctions(property, law, this->Range.Low,
      this->Range.High, samplesOfTable(DefaultAccuracy.TableEntries));
    this->Table = makeIntegralTable(functions);
    this->Visible = std::any_of(this->Table.Values.begin(), this->Table.Values.end(),
      [](const std::array<float, 4>& v) { return v[3] > 0; });
    this->TablesInput = input;
    this->TablesOnGpu = false;
  }
  return this->Visible;
}

bool Pipeline::updateView(vtkRenderer* renderer, vtkVolume* volume)
{
  const double unit = volume->GetProperty()->GetScalarOpacityUnitDistance();
  if (!(unit > 0))
  {
    return this->fail("The scalar opacity unit distance is " + std::to_string(unit) +
                      "; it must be above 0 (vtkVolumeProperty::SetScalarOpacityUnitDistance).");
  }
  if (!makeView(renderer, volume, this->Mesh, unit, this->Camera))
  {
    return this->fail("The matrix of the volume or of the camera is singular or not finite.");
  }
  const bool needsSearch = this->Camera.CutsNearPlane;
  if (needsSearch && !this->Mesh.hasHierarchy())
  {
    ensureHierarchy(this->Mesh);
    this->LinksOnGpu = false;
  }
  return true;
}

bool Pipeline::upload(vtkOpenGLRenderWindow* window)
{
  if (this->Window != window)
  {
    if (this->Window)
    {
      this->Window->MakeCurrent();
      this->release(this->Window);
      window->MakeCurrent();
    }
    this->Window = window;
    this->Watch.begin(window, [this](vtkWindow* ending) { this->release(ending); });
    this->HasFma = hasFusedMultiplyAdd(window);
  }
  if (this->LinksOnGpu && this->ScalarsOnGpu && this->TablesOnGpu)
  {
    return true;
  }
  Recorder recorder(this->UploadRecord);
  std::string error;
  if (!this->LinksOnGpu)
  {
    error = this->MeshOnGpu.uploadLinks(window, this->Mesh);
    this->LinksOnGpu = error.empty();
    this->UploadedBytes += static_cast<std::int64_t>(
      sizeof(Link) * this->Mesh.Links.size() + 16 * this->Mesh.BoundaryFaces.size() +
      sizeof(HierarchyNode) * this->Mesh.Hierarchy.size());
  }
  if (error.empty() && !this->ScalarsOnGpu)
  {
    error = this->MeshOnGpu.uploadVertices(window, this->Mesh);
    if (error.empty())
    {
      error = this->MeshOnGpu.uploadCellScalars(window, this->CellScalars);
    }
    this->ScalarsOnGpu = error.empty();
    this->UploadedBytes += static_cast<std::int64_t>(
      sizeof(Vertex) * this->Mesh.Vertices.size() + sizeof(float) * this->CellScalars.size());
  }
  if (error.empty() && !this->TablesOnGpu)
  {
    error = this->TableOnGpu.upload(window, this->Table);
    this->TablesOnGpu = error.empty();
    this->UploadedBytes += static_cast<std::int64_t>(this->TableOnGpu.bytes());
  }
  if (!error.empty())
  {
    this->release(window);
    return this->fail(error);
  }
  return true;
}

// The renderer, or the render pass that called, has set it.
Viewport Pipeline::currentViewport() const
{
  std::array<int, 4> area{};
  this->Window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, area.data());
  return { area[0], area[1], area[2], area[3] };
}

bool Pipeline::draw(vtkOpenGLRenderWindow* window, vtkRenderer* renderer, bool diagnostics)
{
  this->Counted.clear();
  MarchInputs inputs;
  inputs.Area = this->currentViewport();
  if (inputs.Area.Width <= 0 || inputs.Area.Height <= 0)
  {
    return true;
  }
  VariantKey key;
  key.PointScalars = this->CellScalars.empty();
  key.RasterEntry = !this->Camera.CutsNearPlane;
  key.Hierarchy = this->Mesh.ReentryNodes > 0;
  key.OpaqueDepth = this->Camera.CutsFarPlane || mayHaveOpaqueGeometry(renderer);
  key.HasFma = this->HasFma;
  inputs.Key = key.filtered();
  inputs.Camera = &this->Camera;
  inputs.Mesh = &this->MeshOnGpu;
  inputs.Tables = &this->TableOnGpu;
  inputs.Table = &this->Table;
  inputs.Range = this->Range;

  std::string error;
  if (inputs.Key.RasterEntry)
  {
    error = this->Entry.draw(window, inputs.Area, this->Camera, this->Mesh, this->MeshOnGpu);
    inputs.Entries = error.empty() ? this->Entry.entries() : nullptr;
  }
  if (error.empty() && inputs.Key.OpaqueDepth)
  {
    error = this->Opaque.capture(window, inputs.Area);
    inputs.Depths = this->Opaque.texture();
  }
  if (error.empty() && diagnostics)
  {
    error = this->Counted.collect(window, this->March, inputs);
  }
  if (error.empty())
  {
    error = this->March.draw(window, inputs);
  }
  return error.empty() || this->fail(error);
}

void Pipeline::release(vtkWindow* window)
{
  this->Watch.end(window);
  this->MeshOnGpu.release(window);
  this->TableOnGpu.release(window);
  this->Entry.release(window);
  this->Opaque.release(window);
  this->March.release();
  this->Counted.release(window);
  this->LinksOnGpu = this->ScalarsOnGpu = this->TablesOnGpu = false;
  this->Window = nullptr;
}

std::size_t Pipeline::gpuBytes() const
{
  return this->MeshOnGpu.bytes() + this->TableOnGpu.bytes() + this->Entry.bytes() +
         this->Opaque.bytes();
}

} // namespace tetmarch
