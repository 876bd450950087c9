// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Marches from each vertex towards the light, and keeps how much comes.
#ifndef TetMarchGLVertexLightPass_h
#define TetMarchGLVertexLightPass_h

#include "GL/FloatTarget.h"
#include "GL/MarchPass.h"
#include "Scene/Fingerprint.h"
#include "Scene/StageRecord.h"

#include <string>

namespace tetmarch
{

class VertexLightPass
{
public:
  /** VERTEX_LIGHT_ROW of Shaders/language.glsl: the texels of a row. */
  static constexpr int RowLength = 4096;

  /**
   * Light of so many vertices, unless this version of it is there. Returns an empty string, or what
   * is wrong; `stopped` becomes true if progress asked to stop between two tiles, and the light is
   * begun anew then.
   */
  std::string update(vtkOpenGLRenderWindow* window, const MarchInputs& inputs, std::size_t vertices,
    const Fingerprint& version, const Progress& progress, bool& stopped);
  /** Rows of RGBA: ambient light, then that of up to three lights. */
  vtkTextureObject* texture() const { return this->Target.color(0); }
  const StageRecord& record() const { return this->Record; }
  std::size_t bytes() const { return this->Target.bytes(); }
  /** Four a vertex, as they are on the GPU. */
  std::vector<float> read(vtkOpenGLRenderWindow* window) const
  {
    return this->Target.read(window, 0);
  }
  void release(vtkWindow* window);

private:
  std::string drawTile(vtkOpenGLRenderWindow* window, const MarchInputs& inputs,
    const Viewport& target, const Viewport& tile, std::size_t vertices, bool toLights);

  ShaderDraw Draw;
  FloatTarget Target;
  TileSchedule Tiles;
  Fingerprint Version;
  StageRecord Record;
};

} // namespace tetmarch

#endif
