// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The stages of a frame with what each made last, so that each reruns only when its own input
// changed.
#ifndef TetMarchGLPipeline_h
#define TetMarchGLPipeline_h

#include "GL/ContextWatch.h"
#include "GL/Diagnostics.h"
#include "GL/EntryPass.h"
#include "GL/MarchPass.h"
#include "GL/MeshTextures.h"
#include "GL/OpaqueDepth.h"
#include "GL/TableTextures.h"
#include "Mesh/TetMeshBuilder.h"
#include "Optics/TransferFunctions.h"
#include "Scene/View.h"

#include "vtkWeakPointer.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkRenderer;
class vtkUnstructuredGrid;
class vtkVolume;
class vtkVolumeProperty;

namespace tetmarch
{

/** How long a stage took when it last ran, and how often it ran. */
struct StageRecord
{
  double Seconds = 0;
  std::int64_t Runs = 0;
};

class Pipeline
{
public:
  /**
   * The stages, in the order of a frame. Each returns whether the frame can go on; if not, error()
   * says what is wrong, or is empty if there is nothing to draw or the user stopped it.
   */
  bool updateMesh(vtkUnstructuredGrid* grid, const Progress& progress);
  bool updateScalars(vtkUnstructuredGrid* grid, vtkDataArray* array, bool cellScalars);
  bool updateTables(vtkVolumeProperty* property, OpacityLaw law);
  bool updateView(vtkRenderer* renderer, vtkVolume* volume);
  bool upload(vtkOpenGLRenderWindow* window);
  bool draw(vtkOpenGLRenderWindow* window, vtkRenderer* renderer, bool diagnostics);

  /** Free what is held on the GPU. The context of the window that held it is current. */
  void release(vtkWindow* window);
  /** The window on whose GPU something may be held. */
  vtkOpenGLRenderWindow* window() const { return this->Window; }

  const std::string& error() const { return this->Error; }
  const TetMesh& mesh() const { return this->Mesh; }
  const MarchCounters& counters() const { return this->Counted.counters(); }
  const std::vector<float>& diagnosticPixels() const { return this->Counted.pixels(); }
  std::size_t gpuBytes() const;

  StageRecord MeshRecord;
  StageRecord ScalarsRecord;
  StageRecord TablesRecord;
  StageRecord UploadRecord;
  std::int64_t UploadedBytes = 0;

private:
  using Fingerprint = std::vector<std::uintptr_t>;

  bool fail(const std::string& error);
  Viewport currentViewport() const;

  std::string Error;

  Fingerprint MeshInput;
  TetMesh Mesh;

  Fingerprint ScalarsInput;
  std::vector<float> CellScalars; // empty if point scalars are drawn
  ScalarRange Range;

  Fingerprint TablesInput;
  IntegralTable Table;
  bool Visible = false; // something has extinction

  View Camera;

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  ContextWatch Watch; // of that window
  bool HasFma = false;
  bool LinksOnGpu = false;
  bool ScalarsOnGpu = false;
  bool TablesOnGpu = false;
  MeshTextures MeshOnGpu;
  TableTextures TableOnGpu;
  EntryPass Entry;
  OpaqueDepth Opaque;
  MarchPass March;
  Diagnostics Counted;
};

} // namespace tetmarch

#endif
