// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The planes at which a process ends its rays, if each process has a region of space.
#ifndef TetMarchRegionPlanes_h
#define TetMarchRegionPlanes_h

#include "vtkBoundingBox.h"

#include <vector>

class vtkMatrix4x4;
class vtkPlaneCollection;

namespace tetmarch
{

/**
 * The planes between the region of a process and those of others, in world coordinates. The regions
 * are boxes that fill a box, indexed by process, in coordinates of the data; the matrix transforms
 * these to the world. Sides without a neighbouring region have no plane.
 */
void findRegionPlanes(const std::vector<vtkBoundingBox>& regions, int process, vtkMatrix4x4* place,
  vtkPlaneCollection* planes);

} // namespace tetmarch

#endif
