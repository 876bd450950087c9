// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Volumes, matching faces and counts of a grid, by VTK's own cells
 */
#ifndef tetmarch_testing_GridSummary_h
#define tetmarch_testing_GridSummary_h

#include "GridBuilder.h"

#include <map>
#include <vector>

class vtkCell;

namespace tetmarch::testing
{
/// VTK's faces as polygons with their normals outwards, mid-edge nodes in their places.
std::vector<Ids> facesOf(vtkCell* cell);

/// The signed volume inside faces, by the divergence theorem, each face a fan about the mean of its
/// points: cells that share a face agree on it, also if it is bent.
double volumeOf(vtkUnstructuredGrid* grid, const std::vector<Ids>& faces);

/// Faces are compared as sets of points.
struct GridSummary
{
  double Volume = 0.0;
  double LeastVolume = 0.0;
  vtkIdType FacesInside = 0;     ///< of two cells
  vtkIdType FacesOnBoundary = 0; ///< of one cell
  vtkIdType FacesOfMore = 0;     ///< of three and more
  std::map<int, vtkIdType> Types;
  std::vector<Ids> Boundary; ///< the faces of one cell
};
GridSummary summarise(vtkUnstructuredGrid* grid);
} // namespace tetmarch::testing

#endif
