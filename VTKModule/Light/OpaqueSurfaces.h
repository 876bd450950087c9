// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The opaque surfaces of a scene.
#ifndef TetMarchLightOpaqueSurfaces_h
#define TetMarchLightOpaqueSurfaces_h

#include "Light/TriangleHierarchy.h"

#include <array>
#include <vector>

class vtkCompositeDataDisplayAttributes;
class vtkMapper;
class vtkPolyData;
class vtkRenderer;

namespace tetmarch
{

struct OpaqueSurface
{
  vtkPolyData* Data = nullptr;
  std::array<double, 16> ToWorld{}; // row by row
};

/** What a mapper of composite data draws its blocks with, or nullptr. */
using BlockAttributes = vtkCompositeDataDisplayAttributes* (*)(vtkMapper*);

/**
 * Of the actors that the renderer's props are or are assembled of: those that are visible, opaque
 * and drawn as surfaces, by a mapper of polydata, of composite data of such (but for blocks that
 * are invisible or translucent), or by a vtkDataSetMapper that has drawn before. Mappers' clipping
 * planes are not looked at.
 */
std::vector<OpaqueSurface> opaqueSurfaces(vtkRenderer* renderer, BlockAttributes attributes);

/** Polygons and triangle strips, cut as VTK draws them. */
TriangleHierarchy trianglesOf(vtkPolyData* data);

} // namespace tetmarch

#endif
