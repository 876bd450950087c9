// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which array of the data is drawn, if nobody says.
//
// Arrays that all blocks have, with the same number of components, come before arrays that some
// blocks lack, since these blocks are not drawn. Among them, arrays of physical values come before
// numbers of cells, blocks or materials, and these before arrays whose values are all equal; arrays
// without a finite value come last. Among physical ones points come before cells; of points, and of
// cells, those of one component before those of several, of which the magnitude is drawn, and
// floating-point ones before integers. Of equals the one that the data calls its scalars is taken,
// else the first.
//
// An array holds numbers rather than values if all its values are whole, and its name says so (Ids,
// BlockId, material, vtkOriginalCellIds...), or nearly all of them differ.
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

// Arrays of numbers with a name, but for those that VTK uses itself, those of points first. Of
// arrays of one name and place the first. Arrays that don't fit their blocks (checkLengths) are
// left out.
std::vector<FoundArray> findArrays(const std::vector<vtkDataSet*>& blocks);

struct ArrayWish
{
  std::string Name;             // empty: any
  std::optional<bool> OfCells;  // none: what all blocks have before others, points before cells
  std::optional<int> Component; // none: the first of an array with a name, else the magnitude
};

// What is wrong: no such array, with a list of what there is, or one that doesn't fit its blocks.
// Empty if an array was chosen.
std::string chooseArray(
  const std::vector<vtkDataSet*>& blocks, const ArrayWish& wish, DrawnArray& chosen);

// Whether a name is that of numbers of cells, points, blocks, materials or processes.
bool namesNumbers(const std::string& name);

} // namespace tetmarch

#endif
