// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The texture that holds the light of the vertices; Shaders/light/vertex_light_layout.glsl.
#ifndef TetMarchLightVertexLightLayout_h
#define TetMarchLightVertexLightLayout_h

namespace tetmarch
{

/** A block of so many by so many texels has vertices that are neighbours in space. */
constexpr int VertexLightBlockSide = 8;
/** Texels in a row of the texture. */
constexpr int VertexLightRow = 4096;

} // namespace tetmarch

#endif
