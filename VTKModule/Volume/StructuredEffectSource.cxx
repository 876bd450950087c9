// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volume/StructuredEffectSource.h"

namespace tetmarch
{

std::vector<EffectSource::VertexStart> StructuredEffectSource::vertexStarts() const
{
  const LightNodes& nodes = this->Source.lightNodes();
  std::vector<VertexStart> starts(nodes.count());
  for (std::uint32_t i = 0; i < nodes.count(); ++i)
  {
    const std::array<std::uint32_t, 3> numbers = nodes.numbersOf(i);
    starts[i] = { { numbers[0], numbers[1], numbers[2], 0 } };
  }
  return starts;
}

bool StructuredEffectSource::startPoint(std::size_t, const VertexStart& start, Vector3& point) const
{
  point = this->Source.lightNodes().point({ { start[0], start[1], start[2] } });
  return true;
}

} // namespace tetmarch
