// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a process ends its rays, if each process has a region of space.
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
 * are boxes that fill a box, by the number of their process, in coordinates of the data; the matrix
 * takes these to the world. Outside, where no other region begins, nothing is cut off.
 */
void findRegionPlanes(const std::vector<vtkBoundingBox>& regions, int process, vtkMatrix4x4* place,
  vtkPlaneCollection* planes);

} // namespace tetmarch

#endif
