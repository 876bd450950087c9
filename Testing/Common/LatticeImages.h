// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Small images and rectilinear grids of named fields, in every place and scalar type
 *
 * A field is one of the unit cube (Fields.h), and the cube is stretched over the volume: x goes
 * from 0 at the first point of the first axis to 1 at its last one. So one table of functions over
 * [0, 1] serves all. Each has the active point scalars "f", the field at every point, and the
 * active cell scalars "c", the field at the middle of every cell.
 */
#ifndef tetmarch_testing_LatticeImages_h
#define tetmarch_testing_LatticeImages_h

#include "Fields.h"

#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

namespace tetmarch::testing
{
/// Where an image is.
struct ImagePlace
{
  std::string Name;
  std::array<int, 6> Extent = { 0, 6, 0, 6, 0, 6 };
  std::array<double, 3> Origin = { 0.0, 0.0, 0.0 };
  std::array<double, 3> Spacing = { 1.0, 1.0, 1.0 };
  std::array<double, 9> Direction = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 }; // row-major
};

/// The unit cube in n cells along each edge.
ImagePlace unitCube(int n);

/// Named places: uneven spacing, a far origin, negative spacing, turned, mirrored and sheared
/// directions, an extent that doesn't begin at 0, one cell thick, a single cell; and all at once.
std::vector<ImagePlace> imagePlaces();

/// Coordinates of the points along the axes of a rectilinear grid.
struct AxisCoordinates
{
  std::string Name;
  std::array<std::vector<double>, 3> Axes;
};

/// n + 1 points from 0 to 1 along each axis, whose distances differ by up to a factor of ten.
AxisCoordinates unevenCube(int n, unsigned seed = 1);

/// Named: uneven, growing geometrically, far from 0, one cell thick, 1 x 1 x 1.
std::vector<AxisCoordinates> rectilinearAxes();

/// Scalars of double.
vtkSmartPointer<vtkImageData> imageOf(const Field& field, const ImagePlace& place = unitCube(6));
vtkSmartPointer<vtkRectilinearGrid> rectilinearOf(
  const Field& field, const AxisCoordinates& axes = unevenCube(6));

/// All types of numbers that arrays may have: VTK_CHAR to VTK_ID_TYPE.
std::vector<int> numberTypes();
/// What 0 and 1 become in that type: 3 and 119 in those of 8 bits, more in wider ones, which don't
/// fit into fewer bits; 0 and 1 in floating point.
std::array<double, 2> rangeInType(int vtkType);
/// Both arrays in another type, scaled to rangeInType() and rounded to the nearest number.
void convertScalars(vtkDataSet* data, int vtkType);

/// Marks cells or points in the array vtkGhostType by bits of vtkDataSetAttributes.
using TupleFilter = std::function<bool(vtkIdType id)>;
void markCells(vtkDataSet* data, int bits, const TupleFilter& which);
void markPoints(vtkDataSet* data, int bits, const TupleFilter& which);
/// Makes point and cell scalars not a number.
void spoilScalars(vtkDataSet* data, const TupleFilter& points, const TupleFilter& cells);
} // namespace tetmarch::testing

#endif
