// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a representation draws of its input, where that lies, and which box of it is cropped.
#ifndef TetMarchDrawnData_h
#define TetMarchDrawnData_h

#include "SelectedBlocks.h"

#include "vtkBoundingBox.h"

#include <array>
#include <functional>

class vtkDataObject;
class vtkDataSet;

namespace tetmarch
{

/**
 * A copy of the input, which shares its arrays; of a tree those of its blocks that are selected.
 * `change`, if there is one, is called with each data set of the copy and may add arrays to it.
 * Null if the input is neither a data set nor a tree.
 */
vtkSmartPointer<vtkDataObject> copyToDraw(vtkDataObject* input, const BlockSelection& selection,
  const std::function<void(vtkDataSet*)>& change);

/**
 * Of the data of this process; of images and rectilinear grids without the outer cells that belong
 * to another process. Not valid if there is no data.
 */
vtkBoundingBox boundsOf(vtkDataObject* data);

/**
 * Around the boxes of all processes; each has to call it.
 */
vtkBoundingBox boundsOfAll(const vtkBoundingBox& box);

/**
 * For vtkVolumeMapper::SetCroppingRegionPlanes(): along each axis the bounds of the box times the
 * scale, which may be negative, plus the origin.
 */
std::array<double, 6> croppingPlanes(
  const vtkBoundingBox& box, const double origin[3], const double scale[3]);

} // namespace tetmarch

#endif
