// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The opaque surfaces of a renderer as triangles, for the page.
#ifndef TetMarchWebPageSceneSurfaces_h
#define TetMarchWebPageSceneSurfaces_h

#include "Light/OpaqueSurfaces.h"
#include "WebPage/SurfaceLights.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tetmarch
{

struct Surface
{
  std::array<double, 16> Matrix{};     // from positions to the world, row by row
  std::vector<float> Positions;        // three per point
  std::vector<float> Normals;          // three per point, or none: those of the triangles
  std::vector<std::uint8_t> Colors;    // four per point, or none: of the table or those below
  std::vector<float> TableCoordinates; // two per point, 0..1 in a table of colours, or none
  std::vector<std::uint8_t> Table;     // four per colour, in rows from the bottom
  int TableWidth = 0;
  std::vector<std::uint32_t> Triangles; // three points each
  std::array<double, 3> Color{};        // of diffuse light
  std::array<double, 3> AmbientColor{};
  double Ambient = 0.0;
  double Diffuse = 1.0;
  double Specular = 0.0;
  std::array<double, 3> SpecularColor{};
  double SpecularPower = 1.0;
  bool Lighting = true; // else all light is the colours above
  std::vector<SurfaceLight> Lights;
  bool Flat = false;
  bool FrontFaces = true; // whether they are drawn
  bool BackFaces = true;
};

/**
 * The visible, opaque surfaces of all actors, with the colours that their mappers give them. What
 * else is visible is added to `omissions`, a sentence each, except volumes, scalar bars and axes.
 * Surfaces of a vtkDataSetMapper are found once it has drawn.
 */
std::vector<Surface> opaqueSurfaces(
  vtkRenderer* renderer, std::vector<std::string>& omissions, BlockAttributes attributes = nullptr);

} // namespace tetmarch

#endif
