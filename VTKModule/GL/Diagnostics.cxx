// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/Diagnostics.h"

#include "GL/StateScope.h"

namespace tetmarch
{

std::string Diagnostics::collect(vtkOpenGLRenderWindow* window, MarchPass& march,
  MarchInputs inputs, const Progress& progress, bool& stopped)
{
  this->clear();
  const StageRecorder recorder(this->Record);
  inputs.Key.Diagnostics = true;
  StateScope state(window);
  std::string error = this->Target.bind(window, inputs.Area.Width, inputs.Area.Height, 3);
  if (error.empty())
  {
    error = march.drawApart(window, this->Target, inputs, this->Tiles, progress, stopped);
  }
  if (!error.empty() || stopped)
  {
    return error;
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

void Diagnostics::clear()
{
  this->Counters = {};
  this->Record = {};
  this->Measures.clear();
  this->Pixels.clear();
}

} // namespace tetmarch
