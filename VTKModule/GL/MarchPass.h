// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Marches one ray a pixel, by fragments or by a compute shader.
#ifndef TetMarchGLMarchPass_h
#define TetMarchGLMarchPass_h

#include "GL/ComputeDispatch.h"
#include "GL/DrawContext.h"
#include "GL/FloatTarget.h"
#include "GL/ShaderDraw.h"
#include "GL/TiledDraw.h"
#include "GL/Viewport.h"
#include "Optics/AccuracyLevel.h"
#include "Variants/VariantKey.h"

class vtkShaderProgram;
class vtkTextureObject;

namespace tetmarch
{

struct CapturedProgram;
class EffectTextures;
class FrameStages;
class RayList;
class StateScope;
class TableTextures;
class VolumeTextures;

/** What the march of one visit after another reads, beside the rest (passes/visit.frag.glsl). */
struct VisitInputs
{
  float AtOnce = 0;                      // share of the tolerance that may be used up at the begin
  bool IsFirst = true;                   // then the next two textures have nothing to say
  vtkTextureObject* NextEntry = nullptr; // where the visit before has ended
  vtkTextureObject* RaySoFar = nullptr;  // what its ray has left of the light
  vtkTextureObject* Hidden = nullptr;    // depths behind which nothing is seen, from FirstRow on,
  bool KnowsHidden = false;              // if they are known
  int FirstRow = 0;
  Viewport Part; // of the target, which is marched
};

/** What the march reads. */
struct MarchInputs
{
  VariantKey Key;
  bool ByCompute = false; // by a compute shader; not if the key is Peeled
  Viewport Area;
  const FrameStages* Stages = nullptr; // of the frame, with all that needs no GL
  VolumeTextures* Volume = nullptr;
  TableTextures* Tables = nullptr;
  EffectTextures* Effects = nullptr;
  AccuracyLevel Level = DefaultAccuracy;
  vtkTextureObject* VertexLight = nullptr; // if the key has it
  std::array<double, 16> RayPoints{};
  vtkTextureObject* Depths = nullptr; // if the key has OpaqueDepth: those of the viewport,
  std::array<float, 2> DepthsPerPixel{ { 1, 1 } }; // with so many for each pixel of the area
  std::array<float, 2> ColorWindow{ { 1, 0 } };    // unless the key has Diagnostics
  const PeelHooks* Peeling = nullptr;              // if the key is Peeled
  const VisitInputs* Visits = nullptr;             // visits are marched, one after the other
  const RayList* List = nullptr;                   // its rays are marched, not one a pixel
  double PixelTolerance = 0;                       // of an adaptive picture; 0: one ray a pixel
  bool CountsRays = false;                         // of an adaptive picture
  PictureContent Content;                          // of the area
  Fingerprint LightVersion;                        // of light at vertices, as in VertexLightPass
  double MostSecondsPerDraw = 0;                   // 0: no limit
  double MostLightSeconds = 0;                     // of a frame, for light at vertices; 0: no limit
};

/** Blend premultiplied colours over the framebuffer, without depths. */
void blendPremultiplied(const StateScope& state);

class MarchPass
{
public:
  /**
   * Draw premultiplied colours over the bound framebuffer, by fragments; if the key is Peeled, with
   * the blending that the peeling pass has set.
   */
  StageResult draw(const DrawContext& context, const MarchInputs& inputs, TileSchedule& tiles);
  /** The same without blending, into a bound target of our own that has the size of the area; if
   * the inputs are ByCompute, by a compute shader. */
  StageResult drawApart(const DrawContext& context, const FloatTarget& target,
    const MarchInputs& inputs, TileSchedule& tiles);
  /** The colours of the rays of the inputs' List, into a target of our own that has room for the
   * list as an image. Other texels keep what they have. */
  StageResult drawListed(const DrawContext& context, FloatTarget& target, const MarchInputs& inputs,
    TileSchedule& tiles);
  /** Draw nothing, but capture what the fragment shader of the inputs reads. Returns an empty
   * string, or an error. */
  std::string capture(
    vtkOpenGLRenderWindow* window, const MarchInputs& inputs, CapturedProgram& program);
  void release();

private:
  vtkShaderProgram* use(
    vtkOpenGLRenderWindow* window, const MarchInputs& inputs, std::string& error);
  std::string drawTile(vtkOpenGLRenderWindow* window, const MarchInputs& inputs,
    const Viewport& target, const Viewport& tile);
  std::string dispatchTile(vtkOpenGLRenderWindow* window, const MarchInputs& inputs,
    const FloatTarget& images, const Viewport& tile);
  std::string drawListedTile(vtkOpenGLRenderWindow* window, const MarchInputs& inputs,
    const FloatTarget& target, const Viewport& tile);

  ShaderDraw Draw;
  ComputeDispatch Dispatch;
};

} // namespace tetmarch

#endif
