// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The lists of the faces by which rays of a picture may enter, on the GPU.
#ifndef TetMarchGLEntryListTextures_h
#define TetMarchGLEntryListTextures_h

#include "Entries/EnteredPixels.h"
#include "Entries/EntryLists.h"
#include "GL/TextureBuffer.h"
#include "GL/Uploaded.h"
#include "GL/Viewport.h"

namespace tetmarch
{

struct CapturedProgram;

class EntryListTextures
{
public:
  bool holds(const Fingerprint& version) const { return this->There.holds(version); }
  /** Unless holds(): upload the lists. Returns an empty string, or what is wrong. */
  std::string upload(
    vtkOpenGLRenderWindow* window, const EntryLists& lists, const Fingerprint& version);
  void bind(vtkShaderProgram* program);
  void unbind();
  /** The part of a target that includes all pixels with candidates. */
  Viewport enteredPart(const Viewport& target) const;
  /** Leave the lists out of what was captured: they depend on the view. */
  static void removeFrom(CapturedProgram& captured);
  void release(vtkWindow* window);
  std::size_t bytes() const { return this->Tiles.bytes() + this->Candidates.bytes(); }

private:
  Uploaded There;
  TextureBuffer Tiles;
  TextureBuffer Candidates;
  int TileShift = 0;
  int TilesPerRow = 0;
  std::array<float, 4> DepthPlane{};
  EnteredPixels Entered;
};

} // namespace tetmarch

#endif
