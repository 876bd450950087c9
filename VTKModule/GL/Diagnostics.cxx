// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/Diagnostics.h"

#include "Frame/FrameStages.h"
#include "GL/StateScope.h"

#include <algorithm>

namespace tetmarch
{

StageResult Diagnostics::collect(const DrawContext& context, MarchPass& march, MarchInputs inputs)
{
  vtkOpenGLRenderWindow* window = context.Window;
  this->clear();
  const StageRecorder recorder(this->Record);
  inputs.Key.Diagnostics = true;
  inputs.Key.CurvedError = isAny(inputs.Stages->departure());
  inputs.Key = inputs.Key.filtered();
  StateScope state(window);
  StageResult result{ this->Target.bind(window, inputs.Area.Width, inputs.Area.Height, 3) };
  result = result.then([&] { return march.drawApart(context, this->Target, inputs, this->Tiles); });
  if (!result.isDone())
  {
    return result;
  }
  this->Pixels = this->Target.read(window, 0);
  this->Measures = this->Target.read(window, 1);
  const std::vector<float>& work = this->Measures;
  const std::vector<float> trouble = this->Target.read(window, 2);
  for (std::size_t i = 0; i < work.size(); i += 4)
  {
    this->Counters += { work[i] > 0 ? 1 : 0, static_cast<std::int64_t>(work[i]),
      static_cast<std::int64_t>(work[i + 1]), static_cast<std::int64_t>(trouble[i]),
      static_cast<std::int64_t>(trouble[i + 1]), static_cast<std::int64_t>(trouble[i + 2]) };
  }
  return {};
}

std::string Diagnostics::take(
  vtkOpenGLRenderWindow* window, AdaptivePicture& picture, const MarchInputs& inputs)
{
  std::vector<float> colors;
  const std::string error = picture.read(window, colors);
  if (!error.empty())
  {
    return error;
  }
  const bool asMarched = inputs.ColorWindow == MarchInputs().ColorWindow;
  const Viewport& part = picture.part();
  for (std::size_t i = 0; i < picture.traced().size(); ++i)
  {
    const auto color = colors.begin() + static_cast<std::ptrdiff_t>(4 * i);
    const std::size_t row = part.Y + i / part.Width;
    const std::size_t at = 4 * (row * this->Target.width() + part.X + i % part.Width);
    if (asMarched)
    {
      std::copy(color, color + 4, this->Pixels.begin() + static_cast<std::ptrdiff_t>(at));
    }
    const bool isSeen = this->Measures[at] > 0 || *std::max_element(color, color + 4) > 0;
    if (isSeen && !picture.traced()[i])
    {
      this->Measures[at + 2] = 1;
      this->Measures[at + 3] = 1;
    }
  }
  this->Target.write(1, this->Measures);
  return {};
}

void Diagnostics::clear()
{
  this->Counters = {};
  this->Record = {};
  this->Measures.clear();
  this->Pixels.clear();
}

} // namespace tetmarch
