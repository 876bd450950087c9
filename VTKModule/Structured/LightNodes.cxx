// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Structured/LightNodes.h"

#include "vtkMatrix4x4.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

constexpr int CellsOfNode = 4;
constexpr int MostNodes = 65; // along an axis

} // namespace

std::array<std::uint32_t, 3> LightNodes::numbersOf(std::uint32_t node) const
{
  const auto x = static_cast<std::uint32_t>(this->Along[0]);
  const auto y = static_cast<std::uint32_t>(this->Along[1]);
  return { { node % x, node / x % y, node / x / y } };
}

Vector3 LightNodes::point(const std::array<std::uint32_t, 3>& numbers) const
{
  const auto& m = this->ToNormalized;
  Vector3 point;
  for (int r = 0; r < 3; ++r)
  {
    point[r] =
      m[4 * r] * numbers[0] + m[4 * r + 1] * numbers[1] + m[4 * r + 2] * numbers[2] + m[4 * r + 3];
  }
  return point;
}

LightNodes lightNodesOf(const Lattice& lattice)
{
  LightNodes nodes;
  std::array<double, 16> toLattice{}, toNormalized{};
  std::copy(lattice.FromNormalized.begin(), lattice.FromNormalized.end(), toLattice.begin());
  toLattice[15] = 1;
  vtkMatrix4x4::Invert(toLattice.data(), toNormalized.data());
  for (int k = 0; k < 3; ++k)
  {
    const LatticeAxis& axis = lattice.Axes[k];
    nodes.Along[k] = std::clamp((axis.Cells + CellsOfNode - 1) / CellsOfNode + 1, 2, MostNodes);
    nodes.Low[k] = axis.plane(0);
    nodes.Step[k] = (axis.plane(axis.Cells) - axis.plane(0)) / (nodes.Along[k] - 1);
  }
  for (int r = 0; r < 3; ++r)
  {
    double shift = toNormalized[4 * r + 3];
    for (int k = 0; k < 3; ++k)
    {
      nodes.ToNormalized[4 * r + k] = toNormalized[4 * r + k] * nodes.Step[k];
      shift += toNormalized[4 * r + k] * nodes.Low[k];
    }
    nodes.ToNormalized[4 * r + 3] = shift;
  }
  return nodes;
}

} // namespace tetmarch
