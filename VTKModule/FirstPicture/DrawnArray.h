// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The drawn array: one component, or the magnitude, of the array of one name in all blocks.
#ifndef TetMarchFirstPictureDrawnArray_h
#define TetMarchFirstPictureDrawnArray_h

#include "vtkType.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;

namespace tetmarch
{

struct DrawnArray
{
  vtkDataArray* Array = nullptr; // of the first block that has it
  bool OfCells = false;
  int Component = 0; // -1: the magnitude
};

// The values of one block; without an array if the block lacks it or the component, or if the array
// does not have one tuple for each point or cell.
class DrawnValues
{
public:
  DrawnValues(vtkDataSet* block, const DrawnArray& drawn);

  explicit operator bool() const { return this->Array != nullptr; }
  bool ofCells() const { return this->OfCells; }
  std::optional<std::array<double, 2>> range() const; // of the finite ones; none without

  // Of a point or a cell.
  double at(vtkIdType tuple) const;

private:
  double magnitudeOfExtremes(vtkIdType tuple) const;

  vtkDataArray* Array = nullptr;
  bool OfCells = false;
  int Component = 0;
};

// Of all blocks; none if no value is finite.
std::optional<std::array<double, 2>> rangeOf(
  const std::vector<vtkDataSet*>& blocks, const DrawnArray& drawn);

// Empty, or an error: a block's array of this name does not have one tuple for each point or cell.
std::string checkLengths(const std::vector<vtkDataSet*>& blocks, const DrawnArray& drawn);

// Whether the block is an image or a rectilinear grid; dimensions are its points along each axis.
bool isLattice(vtkDataSet* block, int dimensions[3]);

} // namespace tetmarch

#endif
