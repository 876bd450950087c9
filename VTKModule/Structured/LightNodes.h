// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The points of a structured volume at which light is stored: a coarser lattice, between whose
// nodes light is trilinear. They correspond to a mesh's vertices.
#ifndef TetMarchStructuredLightNodes_h
#define TetMarchStructuredLightNodes_h

#include "Structured/Lattice.h"

#include <array>
#include <cstdint>

namespace tetmarch
{

struct LightNodes
{
  std::array<int, 3> Along{}; // i, j, k: at least two along each axis; numbered with i fastest
  Vector3 Low{};              // position of the first node, in lattice coordinates
  Vector3 Step{};             // between two nodes along each axis
  /** Row-major 3 x 4: from the indices of a node along the axes to the normalised frame. */
  std::array<double, 12> ToNormalized{};

  std::uint32_t count() const
  {
    return static_cast<std::uint32_t>(this->Along[0]) * static_cast<std::uint32_t>(this->Along[1]) *
           static_cast<std::uint32_t>(this->Along[2]);
  }
  std::array<std::uint32_t, 3> numbersOf(std::uint32_t node) const;
  /** In the normalised frame. */
  Vector3 point(const std::array<std::uint32_t, 3>& numbers) const;
};

/** A node for every four cells along an axis, and at both ends; at most 65. */
LightNodes lightNodesOf(const Lattice& lattice);

} // namespace tetmarch

#endif
