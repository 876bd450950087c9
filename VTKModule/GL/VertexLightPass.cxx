// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/VertexLightPass.h"
#include "GL/ClippingBinding.h"

#include "Frame/FrameStages.h"
#include "GL/EffectTextures.h"
#include "GL/LightBinding.h"
#include "GL/StateScope.h"
#include "GL/TableTextures.h"
#include "GL/ThicknessBinding.h"
#include "GL/TileCorners.h"
#include "GL/VolumeTextures.h"
#include "Light/VertexLightLayout.h"

#include "vtkOpenGLRenderUtilities.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace tetmarch
{
namespace
{

constexpr std::size_t VerticesOfBlock = VertexLightBlockSide * VertexLightBlockSide;
constexpr std::size_t BlocksOfRow = VertexLightRow / VertexLightBlockSide;

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// The lights of the pass at vertices; the rays of the picture sample the others.
LightUniforms keptLights(const LightUniforms& lights, const VariantKey& key)
{
  LightUniforms kept = lights;
  if (key.SampledShadows)
  {
    kept.ShadowSources.clear();
  }
  if (key.samplesOcclusion())
  {
    kept.OcclusionDirections = 0;
  }
  return kept;
}

std::string bindRows(vtkOpenGLRenderWindow* window, FloatTarget& target, const Viewport& all)
{
  return target.bind(window, all.Width, all.Height, 1, TargetFormat::Share16);
}

} // namespace

int VertexLightPass::Work::rays() const
{
  return std::max(
    1, static_cast<int>(this->Lights.ShadowSources.size()) + this->Lights.OcclusionDirections);
}

StageResult VertexLightPass::update(const DrawContext& context, const MarchInputs& inputs)
{
  vtkOpenGLRenderWindow* window = context.Window;
  const Fingerprint& version = inputs.LightVersion;
  const std::size_t vertices = inputs.Stages->effects().data().VertexStarts.size();
  this->Complete = version == this->ShownVersion;
  if (this->Complete)
  {
    this->Next.release(window);
    this->NextVersion.clear();
    return {};
  }
  if (version != this->NextVersion)
  {
    this->NextVersion = version;
    this->Made = 0;
    this->Seconds = 0;
    this->Started = false;
  }
  const Clock::time_point begin = Clock::now();
  constexpr std::size_t rowOfBlocks = BlocksOfRow * VerticesOfBlock;
  const int rows =
    VertexLightBlockSide * static_cast<int>((vertices + rowOfBlocks - 1) / rowOfBlocks);
  Work work{ inputs, { 0, 0, VertexLightRow, rows }, vertices,
    keptLights(inputs.Stages->effects().data().Lights, inputs.Key) };
  work.Inputs.Key = inputs.Key.ofVertexLight(inputs.Stages->volume().mayReenter());
  work.Inputs.Level = LightAccuracy;
  const TargetScope state(window, work.All.Width, work.All.Height);
  const bool spread = inputs.MostLightSeconds > 0;
  StageResult result;
  if (spread)
  {
    result.Error = this->showSomething(window, work.All, version.front());
  }
  else if (this->Made == 0)
  {
    // The light that was shown is out of date, so that its texture can be used.
    std::swap(this->Shown, this->Next);
    this->ShownVersion.clear();
  }
  result = result.then([&] { return StageResult{ bindRows(window, this->Next, work.All) }; });
  result = result.then(
    [&] {
      return spread ? StageResult{ this->makePart(window, work) } : this->makeAll(context, work);
    });
  this->Seconds += secondsSince(begin);
  if (result.Error.empty() && this->Made >= vertices)
  {
    std::swap(this->Shown, this->Next);
    this->Next.release(window);
    this->ShownVersion = version;
    this->Complete = true;
    this->Record = { this->Seconds, this->Record.Runs + 1 };
  }
  return result;
}

// The light before, if it is that of the vertices of this mesh; else every transmittance is 1.
std::string VertexLightPass::showSomething(
  vtkOpenGLRenderWindow* window, const Viewport& all, std::uintptr_t mesh)
{
  if (!this->ShownVersion.empty() && this->ShownVersion.front() == mesh)
  {
    return {};
  }
  const std::string error = bindRows(window, this->Shown, all);
  if (error.empty())
  {
    const std::array<float, 4> white{ { 1.0f, 1.0f, 1.0f, 1.0f } };
    glClearBufferfv(GL_COLOR, 0, white.data());
    this->ShownVersion = { mesh };
  }
  return error;
}

StageResult VertexLightPass::makeAll(const DrawContext& context, const Work& work)
{
  const int rowsMade = static_cast<int>(this->Made / VerticesOfBlock / BlocksOfRow);
  const int first = VertexLightBlockSide * rowsMade;
  const Viewport rest{ 0, first, work.All.Width, work.All.Height - first };
  PictureContent content;
  content.Version = this->NextVersion;
  content.RaysPerPixel = work.rays();
  StageResult result = drawInTiles(context, { rest, work.Inputs.MostSecondsPerDraw, content },
    this->Tiles, [&](const Viewport& tile) { return this->drawTile(context.Window, work, tile); });
  glFinish(); // the time is to include the work of the GPU
  this->Made = result.isDone() ? work.Vertices : this->Made;
  return result;
}

std::string VertexLightPass::makePart(vtkOpenGLRenderWindow* window, const Work& work)
{
  glFinish(); // the time is not to include what was drawn before
  const Clock::time_point begin = Clock::now();
  if (!this->Started)
  {
    this->Parts.begin(double(VerticesOfBlock) * work.rays(), work.Inputs.MostLightSeconds);
    this->Started = true;
  }
  std::string error;
  do
  {
    const Clock::time_point beginOfPart = Clock::now();
    const Viewport part = this->nextPart(work.All);
    error = this->drawTile(window, work, part);
    glFinish();
    if (error.empty())
    {
      const auto vertices = static_cast<std::size_t>(part.Width) * part.Height;
      this->Made += vertices;
      this->Parts.done(
        static_cast<std::int64_t>(vertices / VerticesOfBlock), secondsSince(beginOfPart));
    }
  } while (error.empty() && this->Made < work.Vertices &&
           secondsSince(begin) < work.Inputs.MostLightSeconds);
  return error;
}

// Whole rows of blocks, or what the row has left.
Viewport VertexLightPass::nextPart(const Viewport& all) const
{
  const std::size_t block = this->Made / VerticesOfBlock;
  const std::size_t column = block % BlocksOfRow;
  const auto most = static_cast<std::size_t>(this->Parts.next());
  const std::size_t row = block / BlocksOfRow;
  const std::size_t rowsLeft = static_cast<std::size_t>(all.Height) / VertexLightBlockSide - row;
  const std::size_t rows =
    column > 0 || most < BlocksOfRow ? 1 : std::min(most / BlocksOfRow, rowsLeft);
  const std::size_t columns = std::min(most, BlocksOfRow - column);
  const auto texels = [](std::size_t blocks)
  { return VertexLightBlockSide * static_cast<int>(blocks); };
  return { texels(column), texels(row), texels(columns), texels(rows) };
}

vtkShaderProgram* VertexLightPass::useProgram(
  vtkOpenGLRenderWindow* window, const MarchInputs& inputs, std::string& error)
{
  return inputs.ByCompute ? this->Dispatch.use(window, fileOf(VolumePass::VertexLightByCompute),
                              inputs.Key.defines(), error)
                          : this->Draw.use(window, "passes/tile.vert.glsl",
                              fileOf(VolumePass::VertexLight), inputs.Key.defines(), error);
}

std::string VertexLightPass::drawTile(
  vtkOpenGLRenderWindow* window, const Work& work, const Viewport& tile)
{
  const MarchInputs& inputs = work.Inputs;
  std::string error;
  vtkShaderProgram* program = this->useProgram(window, inputs, error);
  if (!program)
  {
    return error;
  }
  inputs.Volume->bind(program, inputs.Key);
  inputs.Tables->bind(program, inputs);
  inputs.Effects->bind(program, inputs.Stages->effects().data(), inputs.Key);
  inputs.Effects->bindVertexRays(program, inputs.Key);
  bindLightRays(program, work.Lights, inputs.Key);
  if (inputs.Key.LightThroughCuts)
  {
    bindClipping(program, inputs.Stages->cuts(), inputs.Key);
  }
  bindThickness(program, inputs.Stages->camera());
  program->SetUniformi("vertexCount", static_cast<int>(work.Vertices));
  if (inputs.ByCompute)
  {
    this->Dispatch.dispatch(program, this->Next, tile);
  }
  else
  {
    drawCorners(program, this->Draw, work.All, tile);
  }
  inputs.Volume->unbind();
  inputs.Tables->unbind();
  inputs.Effects->unbind();
  return {};
}

void VertexLightPass::releasePrograms()
{
  this->Draw.release();
  this->Dispatch.release();
}

void VertexLightPass::release(vtkWindow* window)
{
  this->releasePrograms();
  this->Shown.release(window);
  this->Next.release(window);
  this->Tiles.forget();
  this->ShownVersion.clear();
  this->NextVersion.clear();
}

} // namespace tetmarch
