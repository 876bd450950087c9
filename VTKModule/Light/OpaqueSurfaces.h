// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The opaque surfaces of a scene.
#ifndef TetMarchLightOpaqueSurfaces_h
#define TetMarchLightOpaqueSurfaces_h

#include "Light/TriangleHierarchy.h"

#include <array>
#include <optional>
#include <vector>

class vtkActor;
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
  vtkActor* Actor = nullptr;
  vtkMapper* Mapper = nullptr; // of polydata, or of composite data with such leaves
  std::optional<std::array<double, 3>> BlockColor; // in place of the actor's
};

/** Returns the display attributes of a mapper of composite data, or nullptr. */
using BlockAttributes = vtkCompositeDataDisplayAttributes* (*)(vtkMapper*);

/**
 * The surfaces of all actors of the renderer, also of those in assemblies, that are visible,
 * opaque and drawn as surfaces, by a mapper of polydata, of composite data of polydata (without
 * invisible and translucent blocks), or by a vtkDataSetMapper that has drawn before. Clipping
 * planes of mappers are not considered.
 */
std::vector<OpaqueSurface> opaqueSurfaces(vtkRenderer* renderer, BlockAttributes attributes);

/** The triangles of polygons and triangle strips, as VTK draws them, of all pieces. */
TriangleHierarchy trianglesOf(const std::vector<vtkPolyData*>& pieces);

} // namespace tetmarch

#endif
