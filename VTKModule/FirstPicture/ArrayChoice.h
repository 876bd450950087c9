// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The array that is drawn by default.
// Arrays of all blocks, with the same number of components, come before arrays that some blocks
// lack, since these blocks are not drawn. Among them, arrays of physical values come before numbers
// of cells, blocks or materials, and these before constant arrays; arrays without a finite value
// come last. Among physical ones points come before cells; for each of them, one component before
// several, whose magnitude is drawn, and floating-point values before integers. Among equals the
// active scalars of the data are chosen, else the first.
// An array contains numbers, not physical values, if all its values are integers, and its name
// indicates this (Ids, BlockId, material, vtkOriginalCellIds...), or nearly all of them differ.
#ifndef TetMarchFirstPictureArrayChoice_h
#define TetMarchFirstPictureArrayChoice_h

#include "FirstPicture/DrawnArray.h"

#include <optional>
#include <string>
#include <vector>

namespace tetmarch
{

enum class ArrayKind
{
  Physical,
  Numbers,
  Constant,
  NotFinite // not one value is
};

struct FoundArray
{
  DrawnArray Drawn; // component 0, or the magnitude of several
  ArrayKind Kind = ArrayKind::Physical;
  std::optional<std::array<double, 2>> Range; // of all blocks; none if no value is finite
  bool Everywhere = true;                     // in all blocks, with the same number of components
  bool Floating = true;                       // in one of the blocks at least
  bool Active = false;                        // the scalars of all blocks
};

// Named numeric arrays except VTK's internal ones, those of points first. Of arrays with the same
// name and association the first. Arrays that don't match their blocks (checkLengths) are left out.
std::vector<FoundArray> findArrays(const std::vector<vtkDataSet*>& blocks);

struct ArrayWish
{
  std::string Name;             // empty: any
  std::optional<bool> OfCells;  // none: what all blocks have before others, points before cells
  std::optional<int> Component; // none: the first of an array with a name, else the magnitude
};

// Returns an error: no such array, with a list of existing ones, or one that doesn't match its
// blocks. Empty if an array was chosen.
std::string chooseArray(
  const std::vector<vtkDataSet*>& blocks, const ArrayWish& wish, DrawnArray& chosen);

// Whether a name indicates numbers of cells, points, blocks, materials or processes.
bool namesNumbers(const std::string& name);

} // namespace tetmarch

#endif
