// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The positions of the points of an image or a rectilinear grid, read from VTK and checked.
#ifndef TetMarchInputGridGeometry_h
#define TetMarchInputGridGeometry_h

#include "Geometry/VolumeFrame.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

class vtkDataSet;

namespace tetmarch
{

/** Cheap to read and to compare, so that the same geometry in another data set is recognised. */
struct GridGeometry
{
  std::array<int, 3> Points{}; // along i, j and k
  /** For a rectilinear grid the coordinates along x, y and z, else empty. */
  std::array<std::vector<double>, 3> Coordinates;
  /** For an image: point (a, b, c) is at Origin + a Steps[0] + b Steps[1] + c Steps[2], where a, b
   * and c start at the extent's First. */
  std::array<int, 3> First{};
  Vector3 Origin{};
  std::array<Vector3, 3> Steps{};

  bool isEmpty() const
  {
    return this->Points[0] <= 0 || this->Points[1] <= 0 || this->Points[2] <= 0;
  }
  bool isRectilinear() const { return !this->Coordinates[0].empty(); }
  bool operator==(const GridGeometry& other) const;

  /** The point with these indices, from 0, in coordinates of the data. */
  Vector3 point(const std::array<int, 3>& numbers) const;
};

/** Returns an empty string, or an error of the data with its remedy. Without data or points the
 * geometry is empty, without an error. */
std::string readGeometry(vtkDataSet* data, GridGeometry& geometry);

/** The frame of the bounding box of the points. Returns an empty string, or an error. */
std::string findFrame(const GridGeometry& geometry, VolumeFrame& frame);

/**
 * Row-major 3 x 4: from the normalised frame to lattice coordinates, which are 0 in the middle of
 * each axis, ascend with the index of the point, and have the mean distance of points as unit.
 * Exact to the rounding of its entries, for any distance of the data from the origin.
 */
std::array<double, 12> latticeFromNormalized(
  const GridGeometry& geometry, const VolumeFrame& frame);

/** The position along an axis of the points with this index, from 0, in lattice coordinates. */
double latticePlace(const GridGeometry& geometry, int axis, int number);

} // namespace tetmarch

#endif
