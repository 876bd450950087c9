// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws the boundary faces into a texture: where each pixel's ray enters the mesh.
#ifndef TetMarchGLEntryPass_h
#define TetMarchGLEntryPass_h

#include "GL/FloatTarget.h"
#include "GL/ShaderDraw.h"
#include "GL/Viewport.h"

namespace tetmarch
{

class MeshTextures;
struct TetMesh;
struct View;

class EntryPass
{
public:
  /** Draw the entries of a part of the viewport; other pixels stay as they are. Returns an empty
   * string, or what is wrong. */
  std::string draw(vtkOpenGLRenderWindow* window, const Viewport& viewport, const Viewport& part,
    const View& view, const TetMesh& mesh, MeshTextures& textures);
  vtkTextureObject* entries() const { return this->Target.color(0); }
  void release(vtkWindow* window);
  std::size_t bytes() const { return this->Target.bytes(); }

private:
  FloatTarget Target;
  ShaderDraw Draw;
};

} // namespace tetmarch

#endif
