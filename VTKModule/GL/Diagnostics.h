// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the diagnostic variant of the march counted in one frame.
#ifndef TetMarchGLDiagnostics_h
#define TetMarchGLDiagnostics_h

#include "Caching/StageRecord.h"
#include "Diagnostics/MarchCounters.h"
#include "GL/AdaptivePicture.h"
#include "GL/FloatTarget.h"
#include "GL/MarchPass.h"

#include <string>
#include <vector>

namespace tetmarch
{

class Diagnostics
{
public:
  /** March once more with the counting variant. Nothing is kept unless it is done. */
  StageResult collect(const DrawContext& context, MarchPass& march, MarchInputs inputs);
  /** After collect(): mark the pixels that an adaptive picture of the same inputs interpolates, and
   * take its colours unless they went through a window. Returns an empty string or an error. */
  std::string take(
    vtkOpenGLRenderWindow* window, AdaptivePicture& picture, const MarchInputs& inputs);
  const MarchCounters& counters() const { return this->Counters; }
  /** For each pixel: tetrahedra crossed (0: the ray met nothing), lookups, error bound, and 1 if
   * the pixel is interpolated, and has no other bound than 1. */
  const std::vector<float>& measures() const { return this->Measures; }
  /** Premultiplied RGBA in float, rows from the bottom, of the last collect(). */
  const std::vector<float>& pixels() const { return this->Pixels; }
  /** The time of the last collect(). */
  double seconds() const { return this->Record.Seconds; }
  /** The measures as a texture, until the next collect(). */
  vtkTextureObject* measuresTexture() const { return this->Target.color(1); }
  /** Draw calls of the last collect(), until it was stopped. */
  int numberOfDraws() const { return this->Tiles.numberOfTiles(); }
  std::size_t bytes() const { return this->Target.bytes(); }
  void clear();
  /** Nothing is known of how long the next collect() takes. */
  void forgetTimes() { this->Tiles.forget(); }
  void release(vtkWindow* window) { this->Target.release(window); }

private:
  FloatTarget Target;
  TileSchedule Tiles;
  MarchCounters Counters;
  StageRecord Record;
  std::vector<float> Measures;
  std::vector<float> Pixels;
};

} // namespace tetmarch

#endif
