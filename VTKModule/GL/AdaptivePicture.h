// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A picture with rays where it needs them. First the rays of a coarse grid of pixels are traced,
// then, on grids of half the spacing each, those between rays that disagree; the other pixels are
// interpolated. (Bolin and Meyer 1995, "A frequency based ray tracer", and Levoy 1990, "Volume
// rendering by adaptive refinement", refine pictures like this.)
#ifndef TetMarchGLAdaptivePicture_h
#define TetMarchGLAdaptivePicture_h

#include "GL/EdgeCells.h"
#include "GL/MarchPass.h"
#include "GL/RayList.h"

#include <array>
#include <vector>

namespace tetmarch
{

class AdaptivePicture
{
public:
  /** March the area of the inputs with their PixelTolerance: all of it, or where the volume may be
   * seen. */
  StageResult march(
    const DrawContext& context, MarchPass& march, const MarchInputs& inputs, bool whole);
  /** Blend the picture of the last march() over that of the window. */
  std::string blend(vtkOpenGLRenderWindow* window, const Viewport& area);
  /** Or make a texture of it, if it is whole, of premultiplied colours. Returns an empty string or
   * an error. */
  std::string makePicture(vtkOpenGLRenderWindow* window)
  {
    return this->merge(window, NumberOfGrids - 1);
  }
  vtkTextureObject* picture() const { return this->Pictures.back().color(0); }
  /** Of the pixels of a part of the area, rows from the bottom: which were traced. None if march()
   * was not told to count rays. */
  const Viewport& part() const { return this->Part; }
  const std::vector<char>& traced() const { return this->Traced; }
  /** The colours of the part's pixels, four numbers each. Returns an empty string or an error. */
  std::string read(vtkOpenGLRenderWindow* window, std::vector<float>& colors);
  int numberOfDraws() const;
  void forgetTimes();
  void release(vtkWindow* window);
  std::size_t bytes() const;

private:
  static constexpr int MostSpacing = 8;
  static constexpr int NumberOfGrids = 4; // of 8, 4, 2 and 1 pixels

  static Viewport partOf(const MarchInputs& inputs);
  static int firstGridOf(const MarchInputs& inputs);
  StageResult traceFirst(const DrawContext& context, MarchPass& march, MarchInputs inputs,
    const SampleGrid& grid, int i);
  StageResult refine(const DrawContext& context, MarchPass& march, MarchInputs inputs,
    const SampleGrid& grid, int i);
  std::string merge(vtkOpenGLRenderWindow* window, int i);
  std::string drawMerged(vtkOpenGLRenderWindow* window, int i, const Viewport& area);
  StageResult count(vtkOpenGLRenderWindow* window, const MarchInputs& inputs);

  int First = 0;                                   // of the grids that were used
  std::array<FloatTarget, NumberOfGrids> Pictures; // of the samples of each grid
  std::array<TileSchedule, NumberOfGrids> Tiles;
  Viewport Part; // of the picture
  EdgeCells Edges;
  RayList List;
  FloatTarget Listed; // the colours of the list's rays
  ShaderDraw Draw;
  std::vector<char> Traced;
};

} // namespace tetmarch

#endif
