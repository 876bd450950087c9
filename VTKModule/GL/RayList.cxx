// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/RayList.h"

#include "GL/StateScope.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

constexpr std::size_t MostLevels = 16; // as in passes/ray_list.glsl

// Rows of the list are about as long as half of those of the picture.
int squaresShiftFor(const SampleGrid& grid)
{
  int shift = 0;
  while (16 << shift < grid.Part.Width)
  {
    ++shift;
  }
  return shift;
}

// Room for all pixels but those with two even coordinates, which are samples of the coarser grid.
Viewport imageFor(const SampleGrid& grid)
{
  const int width = 8 << squaresShiftFor(grid);
  const std::int64_t most = std::int64_t(grid.Part.Width) * grid.Part.Height -
                            std::int64_t((grid.Part.Width + 1) / 2) * ((grid.Part.Height + 1) / 2);
  return { 0, 0, width, std::max(8, static_cast<int>((most + 8 * width - 1) / (8 * width)) * 8) };
}

} // namespace

std::vector<RayList::Level> RayList::levelsOver(const SampleGrid& grid)
{
  std::vector<Level> levels{ { 0, grid.width(), grid.height() } };
  std::array<int, 2> begin{ { 0, 0 } }; // of the next level among the even and the odd ones
  do
  {
    int& column = begin[levels.size() % 2];
    const Level& below = levels.back();
    levels.push_back({ column, (below.Width + 1) / 2, (below.Height + 1) / 2 });
    column += levels.back().Width;
  } while (levels.back().Width > 1 || levels.back().Height > 1);
  return levels;
}

std::string RayList::takeAll(vtkOpenGLRenderWindow* window, const SampleGrid& grid)
{
  this->Grid = grid;
  this->Levels = { { 0, grid.width(), grid.height() } };
  this->Image = grid.area();
  SampleGrid last = grid;
  last.Spacing = 2;
  return this->allocate(window, last);
}

// Room for the lists of this grid and of all coarser ones.
std::string RayList::allocate(vtkOpenGLRenderWindow* window, const SampleGrid& last)
{
  const StateScope state(window);
  const std::vector<Level> levels = levelsOver(last);
  std::array<int, 2> width{ { 1, 1 } };
  std::array<int, 2> height{ { 1, 1 } };
  for (std::size_t i = 1; i < levels.size(); ++i)
  {
    width[i % 2] = std::max(width[i % 2], levels[i].Column + levels[i].Width);
    height[i % 2] = std::max(height[i % 2], levels[i].Height);
  }
  std::string error =
    this->Disagreement.bind(window, last.width(), last.height(), 1, TargetFormat::Share16);
  error = error.empty()
            ? this->NewRays.bind(window, last.width(), last.height(), 1, TargetFormat::Share16)
            : error;
  error = error.empty() ? this->Odd.bind(window, width[1], height[1], 1) : error;
  error = error.empty() ? this->Even.bind(window, width[0], height[0], 1) : error;
  return error.empty() ? this->Ranks.bind(window, last.width(), last.height(), 1) : error;
}

std::string RayList::find(vtkOpenGLRenderWindow* window, const SampleGrid& grid,
  vtkTextureObject* picture, vtkTextureObject* edges, double tolerance)
{
  this->Grid = grid.finer();
  this->Levels = levelsOver(grid);
  this->Image = imageFor(grid);

  const TargetScope state(window, grid.width(), grid.height());
  std::string error = this->findDisagreement(window, grid, picture);
  error = error.empty() ? this->findNewRays(window, grid, edges, tolerance) : error;
  for (std::size_t level = 1; level < this->Levels.size() && error.empty(); ++level)
  {
    const Level& at = this->Levels[level];
    state->vtkglViewport(at.Column, 0, at.Width, at.Height);
    error = this->countLevel(window, level);
  }
  state->vtkglViewport(0, 0, grid.width(), grid.height());
  return error.empty() ? this->findRanks(window) : error;
}

std::string RayList::findDisagreement(
  vtkOpenGLRenderWindow* window, const SampleGrid& grid, vtkTextureObject* picture)
{
  const std::string error = this->Disagreement.bindAgain(window);
  return !error.empty() ? error
                        : drawFullView(this->Draw, window, "passes/ray_disagreement.frag.glsl",
                            { { "pictureTexture", picture } },
                            [&](vtkShaderProgram* program) { grid.bind(program); });
}

std::string RayList::findNewRays(
  vtkOpenGLRenderWindow* window, const SampleGrid& grid, vtkTextureObject* edges, double tolerance)
{
  const std::string error = this->NewRays.bindAgain(window);
  return !error.empty()
           ? error
           : drawFullView(this->Draw, window, "passes/new_rays.frag.glsl",
               { { "disagreementTexture", this->Disagreement.color(0) }, { "edgeTexture", edges } },
               [&](vtkShaderProgram* program)
               {
                 grid.bind(program);
                 program->SetUniformf("pixelTolerance", static_cast<float>(tolerance));
               });
}

std::string RayList::countLevel(vtkOpenGLRenderWindow* window, std::size_t level)
{
  const std::string error = this->targetOf(level).bindAgain(window);
  if (!error.empty())
  {
    return error;
  }
  const bool areBits = level == 1;
  const Level& below = this->Levels[level - 1];
  const std::array<int, 2> size{ { below.Width, below.Height } };
  return drawFullView(this->Draw, window, "passes/ray_counts.frag.glsl",
    { { "belowTexture", areBits ? this->NewRays.color(0) : this->targetOf(level - 1).color(0) } },
    [&](vtkShaderProgram* program)
    {
      program->SetUniformi("belowAreBits", areBits ? 1 : 0);
      program->SetUniform2i("belowSize", size.data());
      program->SetUniformi("belowColumn", below.Column);
      program->SetUniformi("column", this->Levels[level].Column);
    });
}

std::string RayList::findRanks(vtkOpenGLRenderWindow* window)
{
  const std::string error = this->Ranks.bindAgain(window);
  return !error.empty()
           ? error
           : drawFullView(this->Draw, window, "passes/ray_ranks.frag.glsl", this->textures(),
               [&](vtkShaderProgram* program) { this->setUniforms(program); });
}

NamedTextures RayList::textures() const
{
  return { { "newRayTexture", this->NewRays.color(0) }, { "oddCountTexture", this->Odd.color(0) },
    { "evenCountTexture", this->Even.color(0) } };
}

void RayList::setUniformsOfImage(vtkShaderProgram* program) const
{
  this->Grid.bind(program);
  program->SetUniformi("squaresShift", squaresShiftFor(this->Grid));
}

void RayList::setUniforms(vtkShaderProgram* program) const
{
  this->setUniformsOfImage(program);
  std::array<int, MostLevels> columns{};
  for (std::size_t i = 0; i < std::min(MostLevels, this->Levels.size()); ++i)
  {
    columns[i] = this->Levels[i].Column;
  }
  program->SetUniform1iv("countColumns", MostLevels, columns.data());
  program->SetUniformi("numberOfLevels", static_cast<int>(this->Levels.size()) - 1);
}

void RayList::bind(vtkShaderProgram* program) const
{
  this->setUniforms(program);
  for (const auto& [name, texture] : this->textures())
  {
    bindImage(program, name, texture);
  }
}

void RayList::unbind() const
{
  for (const auto& [name, texture] : this->textures())
  {
    texture->Deactivate();
  }
}

void RayList::mark(vtkOpenGLRenderWindow* window, std::vector<char>& pixels) const
{
  const auto markSample = [&](int x, int y)
  {
    const Viewport& part = this->Grid.Part;
    const int row = std::min(y * this->Grid.Spacing, part.Height - 1);
    const int column = std::min(x * this->Grid.Spacing, part.Width - 1);
    pixels[std::size_t(row) * part.Width + column] = 1;
  };
  const Level& samples = this->Levels.front();
  const bool all = this->Levels.size() == 1;
  std::vector<float> ranks;
  if (!all)
  {
    this->Ranks.read(window, 0, { 0, 0, samples.Width, samples.Height }, ranks);
  }
  for (int i = 0; i < samples.Width * samples.Height; ++i)
  {
    const int x = i % samples.Width;
    const int y = i / samples.Width;
    const auto bits = all ? 0 : static_cast<int>(std::lround(7 * ranks[4 * std::size_t(i) + 1]));
    for (int bit = 1; bit < 4 && !all; ++bit)
    {
      if (bits >> (bit - 1) & 1)
      {
        markSample(2 * x + (bit & 1), 2 * y + (bit >> 1));
      }
    }
    if (all)
    {
      markSample(x, y);
    }
  }
}

void RayList::release(vtkWindow* window)
{
  this->Disagreement.release(window);
  this->NewRays.release(window);
  this->Odd.release(window);
  this->Even.release(window);
  this->Ranks.release(window);
  this->Draw.release();
}

} // namespace tetmarch
