// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The lights of a renderer, as they light the surfaces of a page.
#ifndef TetMarchWebPageSurfaceLights_h
#define TetMarchWebPageSurfaceLights_h

#include <array>
#include <string>
#include <vector>

class vtkRenderer;

namespace tetmarch
{

struct SurfaceLight
{
  bool FollowsCamera = true;
  std::array<double, 3> Direction{ { 0.0, 0.0, -1.0 } }; // in which it shines, of the view or world
  std::array<double, 3> Color{ { 1.0, 1.0, 1.0 } };
};

/**
 * The lights that are on, of parallel rays; the headlight that VTK would add if there is none.
 * Others are added to `omissions`, a sentence each.
 */
std::vector<SurfaceLight> surfaceLights(vtkRenderer* renderer, std::vector<std::string>& omissions);

} // namespace tetmarch

#endif
