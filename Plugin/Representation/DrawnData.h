// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The drawn data of a representation, their bounds, and the cropping box.
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
 * Whether vtkTetMarchVolumeMapper draws such data: a grid of any cells, curvilinear or explicit, a
 * tree of blocks, an adaptive mesh or a cell grid.
 */
bool isDrawnAsMesh(vtkDataObject* data);

/**
 * A shallow copy of the input; of a tree with its selected blocks. `change`, if given, is called
 * with each data set of the copy and may add arrays to it; not with those of an adaptive mesh, and
 * of a vtkHyperTreeGrid with an unstructured grid of its leaves. Null if the input is none of
 * these.
 */
vtkSmartPointer<vtkDataObject> copyToDraw(vtkDataObject* input, const BlockSelection& selection,
  const std::function<void(vtkDataSet*)>& change);

/**
 * The bounds of this process's data; images and rectilinear grids without the outer cells of
 * another process. Not valid without data.
 */
vtkBoundingBox boundsOf(vtkDataObject* data);

/**
 * The bounds of all processes; each process must call it.
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
