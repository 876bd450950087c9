// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FunctionEdits.h"

#include "vtkColorTransferFunction.h"

#include <algorithm>

namespace
{
template <typename Nodes>
void Stretch(Nodes& nodes, double low, double high)
{
  if (nodes.empty())
  {
    return;
  }
  const double first = nodes.front()[0];
  const double last = nodes.back()[0];
  for (auto& node : nodes)
  {
    node[0] = last > first ? low + (node[0] - first) / (last - first) * (high - low) : low;
  }
  if (last > first)
  {
    nodes.back()[0] = high; // to the last bit
  }
}
} // namespace

namespace tetmarch
{

FunctionSnapshot InvertColors(FunctionSnapshot state)
{
  if (state.Colors.size() < 2)
  {
    return state;
  }
  const std::vector<FunctionSnapshot::ColorNode> old = state.Colors;
  const double low = old.front()[0];
  const double high = old.back()[0];
  const bool logarithmic = state.Scale == VTK_CTF_LOG10 && low > 0.0;
  const std::size_t last = old.size() - 1;
  for (std::size_t i = 0; i <= last; ++i)
  {
    auto& node = state.Colors[i];
    node = old[last - i];
    node[0] = i == 0        ? low
              : i == last   ? high
              : logarithmic ? low / node[0] * high
                            : low + high - node[0];
    // Midpoint and sharpness are those of the curve to the next point, which was the one before.
    node[4] = i < last ? 1.0 - old[last - i - 1][4] : old[last][4];
    node[5] = i < last ? old[last - i - 1][5] : old[last][5];
  }
  return state;
}

FunctionSnapshot FitToRange(FunctionSnapshot state, double low, double high)
{
  Stretch(state.Colors, low, high);
  Stretch(state.Opacities, low, high);
  if (low <= 0.0)
  {
    state.Scale = VTK_CTF_LINEAR; // a logarithm of nothing is none
  }
  return state;
}

} // namespace tetmarch
