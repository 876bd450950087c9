// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The stages of a frame with what each made last, so that each runs again only when its own input
// changed. What is drawn is a MarchSource, of which nothing else is known here.
#ifndef TetMarchGLPipeline_h
#define TetMarchGLPipeline_h

#include "Appearance/TransferTables.h"
#include "Blocks/CellOrigins.h"
#include "Budget/ShaderStage.h"
#include "Caching/Switch.h"
#include "Caching/WithinMemory.h"
#include "GL/ContextWatch.h"
#include "GL/EffectTextures.h"
#include "GL/FramePasses.h"
#include "GL/MarchSource.h"
#include "GL/SelectionPass.h"
#include "GL/TableTextures.h"
#include "Picking/SelectionPoints.h"
#include "Rays/Clipping.h"
#include "Rays/View.h"

#include "vtkWeakPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkRenderer;
class vtkVolume;
class vtkVolumeProperty;

namespace tetmarch
{

struct RayTrace;
struct TraceOptions;

/** How a frame is drawn. */
struct DrawOptions
{
  AccuracyLevel Level = DefaultAccuracy;
  bool Diagnostics = false;
  ShaderStage Stage = ShaderStage::Automatic; // of what is not peeled
  double MostSecondsPerDraw = 0;              // 0: no limit
  double MostLightSeconds = 0;                // of a frame, for light at vertices; 0: no limit
  const MeasureView* View = nullptr;          // drawn instead of the picture
  BoundaryView Boundary = BoundaryView::None; // the same
  double SampleDistance = 1; // between rays, in pixels; 1 with diagnostics or a view
  /** A factor of the picture's colours, and what is added to opaque ones; views and diagnostics
   * have the colours before that. */
  std::array<float, 2> ColorWindow{ { 1, 0 } };
  const PeelHooks* Peeling = nullptr; // only parts of rays are drawn, without diagnostics or a view
  SharedPicture* Shared = nullptr;    // of several processes; without diagnostics, a view or peels
  bool RaysEnd = false;               // some process has opaque geometry
  double PickOpacity = 0.5;           // of a ray at the point where the volume is picked
};

class Pipeline
{
public:
  /** The source lives longer than the pipeline. */
  explicit Pipeline(MarchSource& source)
    : Source(source)
  {
  }

  /** Forget what the last frame drew and its error. The window's context is current; 0 bytes are no
   * limit. */
  void begin(std::uint64_t mostBytes);
  /** The same if something is picked instead: what the last frame counted is kept. */
  void beginPick(std::uint64_t mostBytes);
  /**
   * Run one or more of the stages below. Returns what they return, or false if they lack memory
   * (error()).
   */
  template <typename Stages>
  bool guarded(Stages&& stages)
  {
    bool goesOn = false;
    const std::string shortage = withinMemory("the frame", [&] { goesOn = stages(); });
    return shortage.empty() ? goesOn : this->fail(shortage);
  }
  /**
   * The stages, in the order of a frame. Each returns whether the frame can go on; if not, error()
   * says what is wrong, or is empty if there is nothing to draw or the user stopped it.
   */
  bool updateGeometry(vtkDataSet* data, const Progress& progress);
  bool chooseScalars(vtkDataSet* data, vtkDataArray* array, bool ofCells,
    const VectorOptions& options, vtkVolumeProperty* property, DrawnScalars& drawn);
  bool updateScalars(vtkDataSet* data, const DrawnScalars& drawn);
  bool updateBlending(vtkVolumeProperty* property, const BlendOptions& options);
  /** drawNan: what touches a scalar that is not finite is drawn, in the colour that the colour
   * function has for it. */
  bool updateTables(
    vtkVolumeProperty* property, OpacityLaw law, const AccuracyLevel& level, bool drawNan);
  bool updateEffects(vtkRenderer* renderer, vtkVolume* volume, const EffectOptions& options);
  bool updateView(vtkRenderer* renderer, vtkVolume* volume, OpacityLaw law);
  bool updateClipping(vtkVolume* volume, const ClippingOptions& options);
  bool upload(vtkOpenGLRenderWindow* window);
  bool draw(vtkOpenGLRenderWindow* window, vtkRenderer* renderer, const DrawOptions& options,
    const Progress& progress);
  /** Instead of draw(): what a selector reads from the pixels that it asks for. */
  bool select(vtkOpenGLRenderWindow* window, vtkRenderer* renderer, const DrawOptions& options,
    const CellOrigins& origins, const Progress& progress, std::vector<PickedPoint>& points);

  // If the volume is drawn by several processes, each has a piece of it, which may be empty. They
  // go through the stages side by side, and agree between them (Mapper/MapperFrame.h).

  void setGroup(Group* group, std::uintptr_t generation)
  {
    this->Source.setGroup(group, generation);
  }
  Fingerprint sourceVersion() const { return this->Source.version(); }
  /** How the geometry of the piece is made from the next update on. */
  void setPiece(const PieceOptions& piece) { this->Source.setPiece(piece); }
  /** The ranges of the piece's scalars. */
  std::vector<FiniteRange> findRanges(vtkDataSet* data, const DrawnScalars& drawn);
  /** Whether this process has opaque geometry, or sees the far plane cut the volume. */
  bool endsRays(vtkRenderer* renderer) const;
  /** The processes have agreed that something is wrong: see error(). */
  bool fail(const std::string& error);
  Viewport currentViewport() const;

  /** Wait until the GPU has drawn the frame. */
  void finish() const;

  /**
   * The picture of the last frame in double precision, by the CPU. False if there was no frame, or
   * if the memory for it is lacking (error()), or if progress asked to stop (no error()).
   */
  bool renderReference(
    vtkVolumeProperty* property, OpacityLaw law, const Progress& progress, ReferenceImage& image);
  /** The ray of one pixel of the last frame, marched by the CPU; false likewise, or if the pixel is
   * outside the frame. */
  bool traceRay(
    vtkVolumeProperty* property, OpacityLaw law, const TraceOptions& options, RayTrace& trace);

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

  const std::string& error() const { return this->Error; }
  const MarchSource& source() const { return this->Source; }
  const Diagnostics& counted() const { return this->Passes.counted(); }
  bool isByCompute() const { return this->Passes.isByCompute(); }
  int numberOfDraws() const { return this->Passes.numberOfDraws(); }
  /** Whether the last frame was nothing but drawn: no stage ran, and no shader was new. */
  bool onlyDrew() const;
  /** What the last frame drew, and how large, apart from camera and accuracy. */
  const Fingerprint& subject() const { return this->Subject; }
  std::size_t gpuBytes() const;
  /** How many bytes were uploaded in all. */
  std::int64_t uploadedBytes() const
  {
    return this->Source.uploadedBytes() + this->TablesOnGpu.uploadedBytes() +
           this->EffectsOnGpu.uploadedBytes();
  }
  const EffectStage& effects() const { return this->Effects; }
  // What the last frame showed of the scalars, and what was cut away.
  const Blending& blending() const { return this->Blend; }
  const TransferTables& tables() const { return this->Tables; }
  bool showsNan() const { return this->NanShown; }
  const Clipping& cuts() const { return this->Cut; }
  /** Whether the last frame showed all the light that it was asked for. */
  bool isLightComplete() const { return this->Passes.isLightComplete(); }
  const StageRecord& tablesRecord() const { return this->Tables.record(); }
  const StageRecord& uploadRecord() const { return this->UploadRecord; }
  const StageRecord& vertexLightRecord() const { return this->Passes.vertexLightRecord(); }

private:
  AccuracyLevel levelFor(AccuracyLevel level) const;
  TableInput tableInput(OpacityLaw law) const;
  bool updatePassing();
  void setSubject(vtkVolumeProperty* property, bool drawNan);
  void moveTo(vtkOpenGLRenderWindow* window);
  std::string findPredicate(vtkOpenGLRenderWindow* window);
  std::vector<BufferSize> bufferSizes() const;
  bool useReferenceScene(vtkVolumeProperty* property, OpacityLaw law, const AccuracyLevel& level,
    const std::function<void(ReferenceScene&)>& use);
  std::string prepareEntrySearch();
  std::string describeBadView(const DrawOptions& options) const;
  static std::string describeUnfit(const MarchInputs& inputs, int ofVisits);
  std::string describeBadSamples(const DrawOptions& options) const;
  MarchInputs inputsOf(const DrawOptions& options, vtkRenderer* renderer, const Viewport& area);
  VariantKey keyOf(const DrawOptions& options, vtkRenderer* renderer, const Viewport& area) const;
  Fingerprint lightVersion(const MarchInputs& inputs) const;
  Fingerprint pickVersion(const MarchInputs& inputs, const Viewport& part) const;
  std::int64_t stageRuns() const;
  void forgetErrorsOfReleasing(vtkOpenGLRenderWindow* window);

  std::string Error;
  std::int64_t RunsBefore = 0; // of all stages, before this frame
  Fingerprint Subject;
  ResourceLimits Limits;

  MarchSource& Source;
  ComponentMix Mix = ComponentMix::Single;
  Blending Blend;
  TransferTables Tables;
  bool NanShown = false; // there are scalars that are not finite, and they are shown
  Fingerprint PassingInput;
  Switch PassesCells; // so much is transparent that cells without extinction are passed
  EffectStage Effects;
  View Camera;
  Clipping Cut;
  Viewport Area; // of the last frame; empty: there was none, or not a ray a pixel

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  ContextWatch Watch;            // of that window
  bool PredicateIsKnown = false; // in that window
  bool HasFma = false;
  ComputeSupport Compute;
  TableTextures TablesOnGpu;
  EffectTextures EffectsOnGpu;
  StageRecord UploadRecord;
  FramePasses Passes;
  SelectionPass Selected;
  SelectionPoints Found; // by the first pass of the selection in progress
};

} // namespace tetmarch

#endif
