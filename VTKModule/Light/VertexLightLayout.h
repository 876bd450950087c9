// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The texture of the light at vertices; Shaders/light/vertex_light_layout.glsl.
#ifndef TetMarchLightVertexLightLayout_h
#define TetMarchLightVertexLightLayout_h

namespace tetmarch
{

/** Side of a square block of texels, whose vertices are neighbours in space. */
constexpr int VertexLightBlockSide = 8;
/** Texels in a row of the texture. */
constexpr int VertexLightRow = 4096;

} // namespace tetmarch

#endif
