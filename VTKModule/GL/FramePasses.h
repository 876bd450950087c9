// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The passes of a frame in order: light at vertices, entries, depths of opaque geometry, counters,
// then the picture or a view of what was counted.
#ifndef TetMarchGLFramePasses_h
#define TetMarchGLFramePasses_h

#include "GL/BoundaryViewPass.h"
#include "GL/Diagnostics.h"
#include "GL/DrawOptions.h"
#include "GL/MarchPass.h"
#include "GL/OpaqueDepth.h"
#include "GL/PickPass.h"
#include "GL/PictureApart.h"
#include "GL/PiecesPicture.h"
#include "GL/VertexLightPass.h"
#include "GL/ViewPass.h"

#include <algorithm>

namespace tetmarch
{

class FramePasses
{
public:
  /**
   * Draw a frame. Entries and depths are added to the inputs. A view is drawn instead of the
   * picture, with or without diagnostics; with a view of the boundary nothing is marched or
   * counted.
   */
  StageResult draw(const DrawContext& context, MarchInputs inputs, const DrawOptions& options);
  /**
   * The same by several processes, of the picture alone: collective, from before the depths of
   * opaque geometry on. `before` is what has gone wrong in this process: it takes part then, too.
   */
  StageResult drawDistributed(const DrawContext& context, MarchInputs inputs,
    const DrawOptions& options, const std::string& before);
  /** Find the points at which the rays of a part of the inputs' area are picked (PickPass), for the
   * level's tolerance. The results of the last draw() are kept. */
  StageResult pick(const DrawContext& context, MarchInputs inputs, const Viewport& part,
    std::vector<PickedPoint>& points);
  /** Draw nothing, but capture what the shaders of the picture and of the counters read, at every
   * accuracy that the page of a scene offers. */
  StageResult capture(const DrawContext& context, MarchInputs inputs, CapturedProgram& program);
  /** Capture the visible part of the mesh, too. */
  StageResult captureVisiblePart(
    const DrawContext& context, MarchInputs inputs, CapturedProgram& program);
  /** Nothing is known of how long the next frame takes. */
  void forgetTimes();
  /** Forget the results of the last draw(). */
  void clear();
  void release(vtkWindow* window);

  /** Whether the last picture was drawn by another variant of the shader than the one before. */
  bool changedVariant() const { return this->ChangedVariant; }
  bool isByCompute() const { return this->LastByCompute; }
  /** Draw calls, or dispatches, of the picture, or of the march that a view shows. */
  int numberOfDraws() const { return this->Draws; }
  bool isLightComplete() const
  {
    return !this->LastKey.hasVertexLight() || this->Light.isComplete();
  }
  const StageRecord& vertexLightRecord() const { return this->Light.record(); }
  /** Whether the last picture looked for light through the volume along each ray. */
  bool samplesShadows() const { return this->LastKey.SampledShadows; }
  /** Rays of the last picture, if it was adaptive and they were counted; else 0. */
  std::int64_t tracedRays() const
  {
    const std::vector<char>& traced = this->Apart.adaptive().traced();
    return std::count(traced.begin(), traced.end(), 1);
  }
  const Diagnostics& counted() const { return this->Counted; }
  /** Depths of opaque geometry, one a pixel, if the last frame used them; else empty. */
  std::vector<float> opaqueDepths(vtkOpenGLRenderWindow* window) const
  {
    return this->LastKey.OpaqueDepth ? this->Opaque.read(window) : std::vector<float>();
  }
  std::size_t bytes() const
  {
    return this->Opaque.bytes() + this->Counted.bytes() + this->Shown.bytes() +
           this->Light.bytes() + this->Apart.bytes() + this->Pieces.bytes();
  }

private:
  StageResult updateLight(const DrawContext& context, MarchInputs& inputs);
  StageResult drawSeen(const DrawContext& context, const Viewport& area, const MarchInputs& inputs,
    const DrawOptions& options);
  StageResult drawPicture(const DrawContext& context, const Viewport& area,
    const MarchInputs& inputs, const DrawOptions& options);
  void noteVariant(const MarchInputs& inputs);
  std::string shareDepths(
    vtkOpenGLRenderWindow* window, const Viewport& area, Group& group, std::string before);
  std::string findRays(vtkOpenGLRenderWindow* window, const Viewport& depths, MarchInputs& inputs);
  void releaseUnused(
    vtkWindow* window, const MarchInputs& inputs, const DrawOptions& options, bool apart);

  OpaqueDepth Opaque;
  VertexLightPass Light;
  MarchPass March;
  Diagnostics Counted;
  ViewPass Shown;
  BoundaryViewPass Boundary;
  PictureApart Apart;
  PiecesPicture Pieces;
  PickPass Picking;
  TileSchedule Tiles;
  VariantKey LastKey;
  bool LastByCompute = false;
  bool ChangedVariant = true;
  int Draws = 0;
};

} // namespace tetmarch

#endif
