// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The stages of a frame with what each made last, so that each reruns only when its own input
// changed.
#ifndef TetMarchGLPipeline_h
#define TetMarchGLPipeline_h

#include "Appearance/Components.h"
#include "Blocks/CellOrigins.h"
#include "Caching/Fingerprint.h"
#include "Caching/StageRecord.h"
#include "GL/ContextWatch.h"
#include "GL/EffectTextures.h"
#include "GL/FramePasses.h"
#include "GL/GpuData.h"
#include "GL/SelectionPass.h"
#include "Mesh/HiddenCellStage.h"
#include "Mesh/MeshStage.h"
#include "Optics/FittingTable.h"
#include "Rays/Clipping.h"
#include "Rays/View.h"
#include "Reference/ReferenceImage.h"

#include "vtkWeakPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkRenderer;
class vtkUnstructuredGrid;
class vtkVolume;
class vtkVolumeProperty;

namespace tetmarch
{

struct RayTrace;

/** How a frame is drawn. */
struct DrawOptions
{
  AccuracyLevel Level = DefaultAccuracy;
  bool Diagnostics = false;
  double MostSecondsPerDraw = 0;           // 0: no limit
  double MostLightSeconds = 0;             // for light at vertices; 0: no limit
  const MeasureView* View = nullptr;       // drawn instead of the picture
  BoundaryView Shell = BoundaryView::None; // likewise
  double SampleDistance = 1;               // between rays, in pixels; 1 with any of the others
  const PeelHooks* Peeling = nullptr; // parts of rays are drawn; no diagnostics and no view then
  double PickOpacity = 0.5;           // up to which a ray is followed where something is selected
};

/** How the ray of one pixel is marched by the CPU. */
struct TraceOptions
{
  int X = 0; // of the pixel, counted from the lower left of the window
  int Y = 0;
  AccuracyLevel Level = DefaultAccuracy;
  bool InDouble = false;
  bool ExactLight = false; // light through the volume by brute force; else as the frame has it
};

class Pipeline
{
public:
  /** Forget what the last frame drew and complained of. The window's context is current; 0 bytes
   * are no limit. */
  void begin(std::uint64_t mostBytes);
  /** Likewise, if something is picked instead: what the last frame counted is kept. */
  void beginPick(std::uint64_t mostBytes);
  /**
   * The stages, in the order of a frame. Each returns whether the frame can go on; if not, error()
   * says what is wrong, or is empty if there is nothing to draw or the user stopped it.
   */
  bool updateMesh(vtkUnstructuredGrid* grid, const Progress& progress);
  bool updateHiddenCells(vtkUnstructuredGrid* grid);
  bool updateScalars(vtkUnstructuredGrid* grid, vtkDataArray* array, bool cellScalars,
    const VectorOptions& vector, vtkVolumeProperty* property);
  bool updateBlending(vtkVolumeProperty* property, const BlendOptions& options);
  /** drawNan: what touches a scalar that is not finite is drawn, in the colour function's colour
   * for that. */
  bool updateTables(
    vtkVolumeProperty* property, OpacityLaw law, const AccuracyLevel& level, bool drawNan);
  bool updateEffects(vtkRenderer* renderer, vtkVolume* volume, const EffectOptions& options);
  bool updateView(vtkRenderer* renderer, vtkVolume* volume);
  bool updateClipping(vtkVolume* volume, const ClippingOptions& options);
  bool upload(vtkOpenGLRenderWindow* window);
  bool draw(vtkOpenGLRenderWindow* window, vtkRenderer* renderer, const DrawOptions& options,
    const Progress& progress);
  /** Instead of draw(): what a selector is told of the pixels that it asks for. */
  bool select(vtkOpenGLRenderWindow* window, vtkRenderer* renderer, const DrawOptions& options,
    const CellOrigins& origins, const Progress& progress, std::vector<PickedPoint>& points);

  /**
   * The picture of the last frame in double precision, by the CPU. False if there was no frame, or
   * if the memory for it is lacking (error()).
   */
  bool renderReference(vtkVolumeProperty* property, OpacityLaw law, ReferenceImage& image);
  /** The ray of one pixel of the last frame, marched by the CPU; false likewise, or if the pixel is
   * outside the frame. */
  bool traceRay(
    vtkVolumeProperty* property, OpacityLaw law, const TraceOptions& options, RayTrace& trace);

  /** Free what is held on the GPU. The context of the window that held it is current. */
  void release(vtkWindow* window);
  /** The window on whose GPU something may be held. */
  vtkOpenGLRenderWindow* window() const { return this->Window; }

  const std::string& error() const { return this->Error; }
  const TetMesh& mesh() const { return this->Meshed.mesh(); }
  const ScalarRange& range() const { return this->Range; }
  const StageRecord& meshRecord() const { return this->Meshed.record(); }
  const Diagnostics& counted() const { return this->Passes.counted(); }
  int numberOfDraws() const { return this->Passes.numberOfDraws(); }
  /** Whether the last frame was nothing but drawn: no stage ran, and no shader was new. */
  bool onlyDrew() const;
  /** What the last frame drew, and how large, apart from camera and accuracy. */
  const Fingerprint& subject() const { return this->Subject; }
  std::size_t gpuBytes() const
  {
    return this->OnGpu.bytes() + this->EffectsOnGpu.bytes() + this->Passes.bytes();
  }
  std::int64_t uploadedBytes() const
  {
    return this->OnGpu.uploadedBytes() + this->EffectsOnGpu.uploadedBytes();
  }
  const EffectStage& effects() const { return this->Effects; }
  /** Whether the last frame showed all the light that it was asked for. */
  bool isLightComplete() const { return this->Passes.isLightComplete(); }
  const StageRecord& vertexLightRecord() const { return this->Passes.vertexLightRecord(); }

  StageRecord ScalarsRecord;
  StageRecord TablesRecord;
  StageRecord UploadRecord;

private:
  bool fail(const std::string& error);
  IntegralTable makeTables(vtkVolumeProperty* property, OpacityLaw law, const AccuracyLevel& level,
    Components& parts) const;
  bool ensureHierarchy();
  /** Calls with what the last frame showed, and with tables for a level. */
  bool useReferenceScene(vtkVolumeProperty* property, OpacityLaw law, const AccuracyLevel& level,
    const std::function<void(ReferenceScene&)>& use);
  Viewport currentViewport() const;
  MarchInputs inputsOf(const DrawOptions& options, vtkRenderer* renderer, const Viewport& area);
  VariantKey keyOf(const DrawOptions& options, vtkRenderer* renderer, const Viewport& area) const;
  Fingerprint lightVersion(const VariantKey& key) const;
  std::int64_t stageRuns() const;
  void forgetErrorsOfReleasing(vtkOpenGLRenderWindow* window);

  std::string Error;
  std::int64_t RunsBefore = 0; // this frame
  Fingerprint Subject;
  ResourceLimits Limits;

  MeshStage Meshed;

  HiddenCellStage Hidden;

  Fingerprint ScalarsInput;
  std::vector<float> CellScalars; // empty if point scalars are drawn
  ScalarRange Range;
  Components Parts; // beside that scalar, and how they are drawn together

  Blending Blend;

  Fingerprint TablesInput;
  IntegralTable Table;
  bool Visible = false;  // something has extinction
  bool NanShown = false; // scalars that are not finite, which there are, have

  Fingerprint PassesInput;
  bool PassesCells = false; // much has none

  EffectStage Effects;

  View Camera;
  Clipping Cut;
  Viewport Area; // of the last frame; empty: there was none, or not a ray a pixel

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  ContextWatch Watch; // of that window
  bool HasFma = false;
  GpuData OnGpu;
  EffectTextures EffectsOnGpu;
  FramePasses Passes;
  SelectionPass Selected;
};

} // namespace tetmarch

#endif
