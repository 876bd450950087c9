// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volume/TransparentShare.h"

#include "Parallel/ParallelFor.h"

#include <algorithm>
#include <atomic>

namespace tetmarch
{
namespace
{

template <typename Values, typename Predicate>
double shareOf(const Values& values, const Predicate& has)
{
  std::atomic<std::ptrdiff_t> count(0);
  parallelFor(0, static_cast<vtkIdType>(values.size()),
    [&](vtkIdType begin, vtkIdType end)
    { count += std::count_if(values.begin() + begin, values.begin() + end, has); });
  return static_cast<double>(count) / static_cast<double>(values.size());
}

} // namespace

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
  return cellScalars.empty()
           ? shareOf(mesh.Vertices, [&](const Vertex& v) { return isTransparent(v.Scalar); })
           : shareOf(cellScalars, isTransparent);
}

} // namespace tetmarch
