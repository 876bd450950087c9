// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The rays that a level of an adaptive picture traces. They are found on the GPU, which counts them
// by a pyramid; the CPU never waits for their number.
#ifndef TetMarchGLRayList_h
#define TetMarchGLRayList_h

#include "GL/FloatTarget.h"
#include "GL/FullViewDraw.h"
#include "GL/SampleGrid.h"

#include <cstdint>
#include <vector>

namespace tetmarch
{

class RayList
{
public:
  /** Counts are exact in floats up to this number. */
  static constexpr std::int64_t MostPixels = std::int64_t(1) << 24;

  /** List all samples of a grid; the list as an image is the grid. Makes room for the lists of all
   * finer grids. Returns an empty string, or what is wrong. */
  std::string takeAll(vtkOpenGLRenderWindow* window, const SampleGrid& grid);
  /** List those samples of the next finer grid at which the picture of `grid` is not smooth: where
   * samples differ by more than the tolerance from what their neighbours predict, and in cells with
   * edges (EdgeCells). */
  std::string find(vtkOpenGLRenderWindow* window, const SampleGrid& grid, vtkTextureObject* picture,
    vtkTextureObject* edges, double tolerance);
  /** The grid whose samples are listed. */
  const SampleGrid& grid() const { return this->Grid; }
  /** The list as an image, which has room for all rays. */
  const Viewport& image() const { return this->Image; }
  /** Bind what passes/ray_list.glsl, passes/ray_image.glsl and passes/sample_grid.glsl read. */
  void bind(vtkShaderProgram* program) const;
  void unbind() const;
  /** For passes/merge_rays.frag.glsl, after find(): its uniforms, and the ranks of the list's rays.
   */
  void setUniformsOfImage(vtkShaderProgram* program) const;
  vtkTextureObject* ranks() const { return this->Ranks.color(0); }
  /** Wait for the GPU, and mark the pixels of the list's rays among those of the grid's part. */
  void mark(vtkOpenGLRenderWindow* window, std::vector<char>& pixels) const;
  void release(vtkWindow* window);
  std::size_t bytes() const
  {
    return this->Disagreement.bytes() + this->NewRays.bytes() + this->Odd.bytes() +
           this->Even.bytes() + this->Ranks.bytes();
  }

private:
  /** A level of the pyramid, in the texture of odd or of even ones. */
  struct Level
  {
    int Column;
    int Width;
    int Height;
  };
  static std::vector<Level> levelsOver(const SampleGrid& grid);
  FloatTarget& targetOf(std::size_t level) { return level % 2 == 1 ? this->Odd : this->Even; }
  std::string allocate(vtkOpenGLRenderWindow* window, const SampleGrid& last);
  std::string findDisagreement(
    vtkOpenGLRenderWindow* window, const SampleGrid& grid, vtkTextureObject* picture);
  std::string findNewRays(vtkOpenGLRenderWindow* window, const SampleGrid& grid,
    vtkTextureObject* edges, double tolerance);
  std::string countLevel(vtkOpenGLRenderWindow* window, std::size_t level);
  std::string findRanks(vtkOpenGLRenderWindow* window);
  NamedTextures textures() const;
  void setUniforms(vtkShaderProgram* program) const;

  SampleGrid Grid;
  Viewport Image;
  std::vector<Level> Levels; // the first is NewRays; one: all samples are listed
  FloatTarget Disagreement;  // of samples
  FloatTarget NewRays;
  FloatTarget Odd;
  FloatTarget Even;
  FloatTarget Ranks; // of the rays in the list
  ShaderDraw Draw;
};

} // namespace tetmarch

#endif
