// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What of a frame needs the GL: uploads, passes and drawing, by the stages that need no GL.
#ifndef TetMarchGLPipeline_h
#define TetMarchGLPipeline_h

#include "Blocks/CellOrigins.h"
#include "Frame/FrameScene.h"
#include "Frame/FrameStages.h"
#include "GL/ContextWatch.h"
#include "GL/EffectTextures.h"
#include "GL/FramePasses.h"
#include "GL/SelectionPass.h"
#include "GL/TableTextures.h"
#include "GL/VolumeCapture.h"
#include "GL/VolumeTextures.h"
#include "Picking/SelectionPoints.h"

#include "vtkWeakPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkRenderer;
class vtkVolumeProperty;

namespace tetmarch
{

class Pipeline
{
public:
  /** Volume and textures live longer than the pipeline. */
  Pipeline(MarchedVolume& volume, VolumeTextures& textures)
    : Stages(volume)
    , Textures(textures)
  {
  }

  /** Forget what the last frame drew. The window's context is current; 0 bytes are no limit. */
  void begin(std::uint64_t mostBytes);
  /** The same if something is picked instead: what the last frame counted is kept. */
  void beginPick(std::uint64_t mostBytes);

  /** All stages but the last, which is draw() or select(). */
  StageResult update(
    vtkOpenGLRenderWindow* window, const FrameInput& input, const Progress& progress);
  // The first and the last part of the same, as in FrameStages.
  StageResult updateGeometry(const FrameInput& input, const Progress& progress);
  StageResult updateRays(vtkOpenGLRenderWindow* window, const FrameInput& input);

  StageResult draw(vtkOpenGLRenderWindow* window, vtkRenderer* renderer, const DrawOptions& options,
    const Progress& progress);
  /** Instead of draw(): what a selector reads from the pixels that it asks for. */
  StageResult select(vtkOpenGLRenderWindow* window, vtkRenderer* renderer,
    const DrawOptions& options, const CellOrigins& origins, const Progress& progress,
    std::vector<PickedPoint>& points);

  /** Instead of draw(): what a page that draws the volume needs. */
  StageResult capture(vtkOpenGLRenderWindow* window, vtkRenderer* renderer,
    const DrawOptions& options, const Progress& progress, CapturedVolume& captured);

  /** Whether this process has opaque geometry, or sees the far plane cut the volume. */
  bool endsRays(vtkRenderer* renderer) const;
  Viewport currentViewport() const;

  /** Wait until the GPU has drawn the frame. */
  void finish() const;

  /**
   * The picture of the last frame in double precision, by the CPU. It fails if there was no frame,
   * or if the memory for it is lacking, and stops if progress asks for it.
   */
  StageResult renderReference(vtkVolumeProperty* property, const AccuracyLevel& level,
    const Progress& progress, ReferenceImage& image);
  /** The ray of one pixel of the last frame, marched by the CPU. It fails likewise, and if the
   * pixel is outside the frame. */
  StageResult traceRay(vtkVolumeProperty* property, const TraceOptions& options, RayTrace& trace);

  /** Free what is held on the GPU. The context of the window that held it is current. */
  void release(vtkWindow* window);
  /** The same for the window that holds something, if there is one; its context becomes current. */
  void releaseWhereHeld();
  /** The same if it is that window. */
  void releaseIfHeldBy(vtkWindow* window);
  /** Make the context of the window that holds something current, if there is one. */
  void makeCurrent() const;
  /** The window on whose GPU something may be held. */
  vtkOpenGLRenderWindow* window() const { return this->Window; }

  FrameStages& stages() { return this->Stages; }
  const FrameStages& stages() const { return this->Stages; }
  const Diagnostics& counted() const { return this->Passes.counted(); }
  bool isByCompute() const { return this->Passes.isByCompute(); }
  int numberOfDraws() const { return this->Passes.numberOfDraws(); }
  /** Whether the last frame was nothing but drawn: no stage ran, and no shader was new. */
  bool onlyDrew() const;
  /** Of the last frame, with its size: see FrameStages::contentVersion(). */
  const Fingerprint& contentVersion() const { return this->Content; }
  std::size_t gpuBytes() const;
  /** How many bytes were uploaded in all. */
  std::int64_t uploadedBytes() const
  {
    return this->Textures.uploadedBytes() + this->TablesOnGpu.uploadedBytes() +
           this->EffectsOnGpu.uploadedBytes();
  }
  /** Whether the last frame showed all the light that it was asked for. */
  bool isLightComplete() const { return this->Passes.isLightComplete(); }
  const StageRecord& uploadRecord() const { return this->UploadRecord; }
  const StageRecord& vertexLightRecord() const { return this->Passes.vertexLightRecord(); }
  std::int64_t tracedRays() const { return this->Passes.tracedRays(); }
  /** With which the last picture was drawn; 0: a ray for each pixel. */
  double pixelTolerance() const { return this->PixelTolerance; }

private:
  void moveTo(vtkOpenGLRenderWindow* window);
  std::string findPredicate(vtkOpenGLRenderWindow* window);
  std::string upload(vtkOpenGLRenderWindow* window);
  std::vector<BufferSize> bufferSizes() const;
  StageResult useReferenceScene(vtkVolumeProperty* property, const AccuracyLevel& level,
    bool isTruth, const std::function<void(FrameScene&)>& use);
  std::string describeBadOptions(const DrawOptions& options) const;
  std::string describeBadView(const DrawOptions& options) const;
  static std::string describeUnfit(const MarchInputs& inputs, int ofVisits);
  MarchInputs inputsOf(const DrawOptions& options, vtkRenderer* renderer, const Viewport& area);
  bool boundsCurvedCells(const DrawOptions& options) const;
  VariantKey keyOf(const DrawOptions& options, vtkRenderer* renderer, const Viewport& area) const;
  VariantKey withEntries(VariantKey key) const;
  std::string prepareSearch(vtkOpenGLRenderWindow* window, const VariantKey& key);
  Fingerprint lightVersion(const MarchInputs& inputs) const;
  Fingerprint pickVersion(const MarchInputs& inputs, const Viewport& part) const;
  StageResult findPicked(const DrawContext& context, MarchInputs inputs, const Viewport& part,
    std::vector<PickedPoint>& points);
  std::int64_t stageRuns() const;
  void forgetErrorsOfReleasing(vtkOpenGLRenderWindow* window);

  ResourceLimits Limits;
  FrameStages Stages;
  std::int64_t RunsBefore = 0; // of all stages, before this frame
  Fingerprint Content;
  Viewport Area; // of the last frame; empty: there was none, or not a ray a pixel
  double PixelTolerance = 0;

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  ContextWatch Watch;            // of that window
  bool PredicateIsKnown = false; // in that window
  bool HasFma = false;
  ComputeSupport Compute;
  VolumeTextures& Textures;
  TableTextures TablesOnGpu;
  EffectTextures EffectsOnGpu;
  StageRecord UploadRecord;
  FramePasses Passes;
  SelectionPass Selected;
  SelectionPoints Found; // by the first pass of the selection in progress
};

} // namespace tetmarch

#endif
