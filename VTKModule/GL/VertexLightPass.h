// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Marches from each vertex towards the light, and keeps the transmittance.
#ifndef TetMarchGLVertexLightPass_h
#define TetMarchGLVertexLightPass_h

#include "Budget/GrowingParts.h"
#include "Caching/Fingerprint.h"
#include "Caching/StageRecord.h"
#include "GL/FloatTarget.h"
#include "GL/MarchPass.h"
#include "Light/LightUniforms.h"

#include <cstdint>
#include <string>

namespace tetmarch
{

class VertexLightPass
{
public:
  /**
   * Make the light of all vertices, unless this version of it is there. The first word of
   * the version is that of the geometry.
   *
   * If the inputs limit its time, a part is made and the rest left to the next calls: until all of
   * it is there, the light before is shown, or every transmittance is 1.
   */
  StageResult update(const DrawContext& context, const MarchInputs& inputs);
  /** Blocks of RGBA: ambient light, then that of up to three lights. */
  vtkTextureObject* texture() const { return this->Shown.color(0); }
  /** Whether texture() has the light that the last update() asked for. */
  bool isComplete() const { return this->Complete; }
  /** A run makes all of the light, in one or several frames. */
  const StageRecord& record() const { return this->Record; }
  std::size_t bytes() const { return this->Shown.bytes() + this->Next.bytes(); }
  void releasePrograms();
  void release(vtkWindow* window);

private:
  struct Work
  {
    int rays() const; // from a vertex
    MarchInputs Inputs;
    Viewport All; // all texels of the texture
    std::size_t Vertices;
    LightUniforms Lights; // those that the rays of the picture don't sample
  };

  std::string showSomething(
    vtkOpenGLRenderWindow* window, const Viewport& all, std::uintptr_t mesh);
  StageResult makeAll(const DrawContext& context, const Work& work);
  std::string makePart(vtkOpenGLRenderWindow* window, const Work& work);
  Viewport nextPart(const Viewport& all) const;
  vtkShaderProgram* useProgram(
    vtkOpenGLRenderWindow* window, const MarchInputs& inputs, std::string& error);
  std::string drawTile(vtkOpenGLRenderWindow* window, const Work& work, const Viewport& tile);

  ShaderDraw Draw;
  ComputeDispatch Dispatch;
  FloatTarget Shown;
  FloatTarget Next; // the light that is being made
  Fingerprint ShownVersion;
  Fingerprint NextVersion;
  std::size_t Made = 0; // vertices whose light is made
  double Seconds = 0;   // that this has taken so far
  bool Started = false; // parts of it
  bool Complete = false;
  TileSchedule Tiles; // of light that is made at once
  GrowingParts Parts; // of light that is spread over frames
  StageRecord Record;
};

} // namespace tetmarch

#endif
