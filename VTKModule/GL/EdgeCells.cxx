// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/EdgeCells.h"

#include "Frame/FrameStages.h"
#include "GL/FullViewDraw.h"
#include "GL/StateScope.h"

namespace tetmarch
{
namespace
{

std::size_t levelOf(int spacing) { return spacing == 2 ? 0 : (spacing == 4 ? 1 : 2); }

} // namespace

std::string EdgeCells::find(
  vtkOpenGLRenderWindow* window, const MarchInputs& inputs, const Viewport& part, int spacing)
{
  SampleGrid grid{ part, 2 };
  std::string error = this->updateOutlines(window, inputs, grid);
  this->HasDepths = inputs.Depths != nullptr;
  error = error.empty() && this->HasDepths ? this->drawFinest(window, inputs, grid) : error;
  for (std::size_t level = 1; level <= levelOf(spacing) && error.empty(); ++level)
  {
    error = this->drawCoarser(window, level, grid);
    grid.Spacing *= 2;
  }
  return error;
}

std::string EdgeCells::updateOutlines(
  vtkOpenGLRenderWindow* window, const MarchInputs& inputs, const SampleGrid& grid)
{
  const MarchedVolume& volume = inputs.Stages->volume();
  if (volume.geometryVersion() != this->EdgesVersion)
  {
    this->Edges = volume.outlineEdges();
    this->EdgesVersion = volume.geometryVersion();
  }
  const View& view = inputs.Stages->camera();
  const Viewport& part = grid.Part;
  Fingerprint version = this->EdgesVersion;
  addAll(version, view.NormalizedToClip);
  addAll(version, std::array<int, 6>{ { inputs.Area.Width, inputs.Area.Height, part.X, part.Y,
                    part.Width, part.Height } });
  if (this->Outlines.texture() && version == this->OutlinesVersion)
  {
    return {};
  }
  this->OutlinesVersion = version;
  const PictureCells cells{ { { inputs.Area.Width, inputs.Area.Height } }, { { part.X, part.Y } },
    grid.Spacing, { { grid.width(), grid.height() } } };
  return this->Outlines.upload(
           window, grid.width(), grid.height(), 1, outlineCells(this->Edges, view, cells))
           ? std::string()
           : "The GPU has no room for the outlines of a picture of " + std::to_string(part.Width) +
               " x " + std::to_string(part.Height) +
               " pixels. Close what else uses it, or make the window smaller.";
}

std::string EdgeCells::drawFinest(
  vtkOpenGLRenderWindow* window, const MarchInputs& inputs, const SampleGrid& grid)
{
  const TargetScope state(window, grid.width(), grid.height());
  const std::string error =
    this->Cells[0].bind(window, grid.width(), grid.height(), 1, TargetFormat::Share16);
  return !error.empty() ? error
                        : drawFullView(this->Draw, window, "passes/edge_cells.frag.glsl",
                            { { "outlineTexture", this->Outlines.texture() },
                              { "opaqueDepthTexture", inputs.Depths } },
                            [&](vtkShaderProgram* program)
                            {
                              grid.bind(program);
                              program->SetUniform2f("depthsPerPixel", inputs.DepthsPerPixel.data());
                            });
}

// `finer` is the grid of the cells half as large.
std::string EdgeCells::drawCoarser(
  vtkOpenGLRenderWindow* window, std::size_t level, const SampleGrid& finer)
{
  SampleGrid grid = finer;
  grid.Spacing *= 2;
  const std::array<int, 2> last{ { finer.width() - 1, finer.height() - 1 } };
  const TargetScope state(window, grid.width(), grid.height());
  const std::string error =
    this->Cells[level].bind(window, grid.width(), grid.height(), 1, TargetFormat::Share16);
  return !error.empty()
           ? error
           : drawFullView(this->Draw, window, "passes/coarser_edge_cells.frag.glsl",
               { { "edgeTexture", this->texture(finer) } },
               [&](vtkShaderProgram* program) { program->SetUniform2i("lastCell", last.data()); });
}

vtkTextureObject* EdgeCells::texture(const SampleGrid& grid) const
{
  const std::size_t level = levelOf(grid.Spacing);
  return level == 0 && !this->HasDepths ? this->Outlines.texture() : this->Cells[level].color(0);
}

void EdgeCells::release(vtkWindow* window)
{
  this->Outlines.release(window);
  for (FloatTarget& cells : this->Cells)
  {
    cells.release(window);
  }
  this->Draw.release();
}

std::size_t EdgeCells::bytes() const
{
  return this->Outlines.bytes() + this->Cells[0].bytes() + this->Cells[1].bytes() +
         this->Cells[2].bytes();
}

} // namespace tetmarch
