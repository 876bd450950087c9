// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volume/TransparentShare.h"

#include <algorithm>

namespace tetmarch
{

double transparentShare(const TetMesh& mesh, const std::vector<float>& cellScalars,
  const ScalarRange& range, const IntegralTable& table)
{
  if (!table.Traits.hasTransparentRanges() || mesh.Vertices.empty())
  {
    return 0;
  }
  const auto scale = static_cast<float>(table.scale(range.width()));
  const auto offset = static_cast<float>(table.offset(range.Low));
  const std::array<float, 4>& ranges = table.Traits.Transparent;
  const auto isTransparent = [&](float scalar)
  {
    const float x = scalar * scale + offset;
    return x <= ranges[0] || x >= ranges[1] || (x >= ranges[2] && x <= ranges[3]);
  };
  if (!cellScalars.empty())
  {
    return static_cast<double>(
             std::count_if(cellScalars.begin(), cellScalars.end(), isTransparent)) /
           static_cast<double>(cellScalars.size());
  }
  return static_cast<double>(std::count_if(mesh.Vertices.begin(), mesh.Vertices.end(),
           [&](const Vertex& v) { return isTransparent(v.Scalar); })) /
         static_cast<double>(mesh.Vertices.size());
}

} // namespace tetmarch
