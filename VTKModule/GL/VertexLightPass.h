// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Marches from each vertex towards the light, and keeps how much comes.
#ifndef TetMarchGLVertexLightPass_h
#define TetMarchGLVertexLightPass_h

#include "Caching/Fingerprint.h"
#include "Caching/StageRecord.h"
#include "GL/FloatTarget.h"
#include "GL/MarchPass.h"

#include <cstdint>
#include <string>

namespace tetmarch
{

class VertexLightPass
{
public:
  /**
   * Light of so many vertices, unless this version of it is there; the first word of a version is
   * that of the mesh. Returns an empty string, or what is wrong; `stopped` becomes true if progress
   * asked to stop between two tiles.
   *
   * If the inputs limit its time, a part is made and the rest left to the next calls: until all of
   * it is there, the light that was there before is shown, or none is kept off.
   */
  std::string update(vtkOpenGLRenderWindow* window, const MarchInputs& inputs, std::size_t vertices,
    const Fingerprint& version, const Progress& progress, bool& stopped);
  /** Blocks of RGBA: ambient light, then that of up to three lights. */
  vtkTextureObject* texture() const { return this->Shown.color(0); }
  /** Whether texture() is what the last update() was asked for. */
  bool isComplete() const { return this->Complete; }
  /** A run is what makes all of the light, over however many frames. */
  const StageRecord& record() const { return this->Record; }
  std::size_t bytes() const { return this->Shown.bytes() + this->Next.bytes(); }
  void release(vtkWindow* window);

private:
  struct Work
  {
    MarchInputs Inputs;
    Viewport All; // of the texture
    std::size_t Vertices;
    bool ToLights; // or ambient light alone
  };

  std::string showSomething(
    vtkOpenGLRenderWindow* window, const Viewport& all, std::uintptr_t mesh);
  std::string makeAll(
    vtkOpenGLRenderWindow* window, const Work& work, const Progress& progress, bool& stopped);
  std::string makePart(vtkOpenGLRenderWindow* window, const Work& work);
  std::string drawTile(vtkOpenGLRenderWindow* window, const Work& work, const Viewport& tile);

  ShaderDraw Draw;
  FloatTarget Shown;
  FloatTarget Next; // while it is being made
  Fingerprint ShownVersion;
  Fingerprint NextVersion;
  std::size_t Made = 0; // vertices of it
  double Seconds = 0;   // that it took as yet
  bool Complete = false;
  TileSchedule Tiles;
  StageRecord Record;
};

} // namespace tetmarch

#endif
