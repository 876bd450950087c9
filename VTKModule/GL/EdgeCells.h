// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells between the samples of a picture in which it may have an edge that no ray touches: the
// outline of the volume, and jumps in the depths of opaque geometry.
#ifndef TetMarchGLEdgeCells_h
#define TetMarchGLEdgeCells_h

#include "Caching/Fingerprint.h"
#include "Entries/Outlines.h"
#include "GL/FloatTarget.h"
#include "GL/MarchPass.h"
#include "GL/SampleGrid.h"
#include "GL/ShaderDraw.h"
#include "GL/UploadedImage.h"

#include <array>

namespace tetmarch
{

class EdgeCells
{
public:
  /** For the grids of a part of the picture whose spacing is at most `spacing`, a power of two from
   * 2 to 8. Returns an empty string, or what is wrong. */
  std::string find(
    vtkOpenGLRenderWindow* window, const MarchInputs& inputs, const Viewport& part, int spacing);
  /** 1 in red where the cell right above a sample of the grid has an edge. */
  vtkTextureObject* texture(const SampleGrid& grid) const;
  void release(vtkWindow* window);
  std::size_t bytes() const;

private:
  std::string updateOutlines(
    vtkOpenGLRenderWindow* window, const MarchInputs& inputs, const SampleGrid& grid);
  std::string drawFinest(
    vtkOpenGLRenderWindow* window, const MarchInputs& inputs, const SampleGrid& grid);
  std::string drawCoarser(vtkOpenGLRenderWindow* window, std::size_t level, const SampleGrid& grid);

  std::vector<OutlineEdge> Edges;
  Fingerprint EdgesVersion; // of the geometry that they belong to
  UploadedImage Outlines;
  Fingerprint OutlinesVersion;      // of the geometry, the camera and the cells
  std::array<FloatTarget, 3> Cells; // of 2, 4 and 8 pixels; without depths the first are Outlines
  bool HasDepths = false;
  ShaderDraw Draw;
};

} // namespace tetmarch

#endif
