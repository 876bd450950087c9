// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A grid, its scalars and transfer functions in a few bytes, any of which mean something
 *
 * In this order; what is missing at the end is 0:
 *   flags     bit 0: 32-bit cell storage; 1: float points; 2: scalars of cells, not of points;
 *             3: a gray function, not colours; 4: higher order degrees; 5: rational weights;
 *             6: the opacity law of structured grids
 *   seed      of the rays
 *   scale     the unit of coordinates, an index into a list from 1 to 1e-300 and 1e99
 *   points    their number, then three numbers each
 *   cells     their number; each: a type, an index into the list of 3D types or, from 128 on, VTK's
 *             number plus 128; for types of any number of points that number; the points. For
 *             polyhedra instead the number of faces and for each of them that of points; the points
 *   damage    their number; each: array, what is done, where (two bytes), which value
 *   scalars   type of array, components, how many tuples are too many (signed), one number each
 *   functions number of nodes, for each of them colour and opacity
 *   degrees, weights  if the flags say so
 * A number is a signed byte; -128 means that the next byte is an index into a list of NaN,
 * infinities and other wild ones.
 */
#ifndef tetmarch_testing_GridCode_h
#define tetmarch_testing_GridCode_h

#include "Optics/TransferFunctions.h"

#include "RawGrid.h"

#include "vtkSmartPointer.h"

#include <cstdint>

class vtkDataArray;
class vtkVolumeProperty;

namespace tetmarch::testing
{
using Bytes = std::vector<std::uint8_t>;

struct FuzzInput
{
  Grid Cells;
  vtkSmartPointer<vtkDataArray> Scalars;
  bool OfCells = false;
  vtkSmartPointer<vtkVolumeProperty> Property;
  OpacityLaw Law = OpacityLaw::Unstructured;
  unsigned Seed = 0;
};

FuzzInput decode(const Bytes& bytes);

/// A sound grid of at most 255 points and cells, coordinates rounded to 1/250 of its extent, with
/// scalars; flags as above.
Bytes encode(vtkUnstructuredGrid* grid, std::uint8_t flags, std::uint8_t seed);
} // namespace tetmarch::testing

#endif
