// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The data of the effects of light and gradients, on the CPU.
#ifndef TetMarchLightEffectData_h
#define TetMarchLightEffectData_h

#include "Light/LightUniforms.h"
#include "Light/OpaqueShadows.h"
#include "Optics/GradientOpacityTable.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tetmarch
{

struct EffectData
{
  /** Gradients of the stored scalar: one per vertex or, if CellGradients, per tetrahedron. Of
   * independent components: one each per vertex. */
  std::vector<std::array<float, 3>> Gradients;
  bool CellGradients = false;
  GradientOpacityTable GradientOpacity; // may be empty
  double GradientOpacityScale = 0; // from the magnitude of a gradient to a position in the table
  LightUniforms Lights;            // empty: unlit
  /** Starting points of rays from vertices, see Mesh/VertexStarts.h. */
  std::vector<std::array<std::uint32_t, 4>> VertexStarts; // if there are shadows or occlusion
  OpaqueShadows Opaque;
  /** For each vertex, bit k is 1 if opaque geometry blocks the light of shadow source k. Empty
   * without such geometry, or if rays of the picture certainly sample it. */
  std::vector<std::uint8_t> ShadowedVertices;

  bool empty() const { return this->GradientOpacity.empty() && this->Lights.Sources.empty(); }
};

} // namespace tetmarch

#endif
