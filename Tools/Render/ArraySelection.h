// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which array of the data is drawn.
 */
#ifndef tetmarch_ArraySelection_h
#define tetmarch_ArraySelection_h

#include "CommandLine.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkDataSet;

namespace tetmarch
{

struct ArraySelection
{
  vtkSmartPointer<vtkDataArray> Array; // of the first block that has it
  Association Where = Association::POINTS;
  int Component = 0; // that is drawn, as vtkDataArray::GetRange() has it: -1 is the magnitude
};

/**
 * The array of the given name; without a name the first floating-point array with one component,
 * else the first with several, else the first of integers, else the first whose values are all
 * equal. Points come before cells unless where says otherwise. Throws Failure that lists what there
 * is, or says how many components there are. The magnitude of a single one is itself.
 */
ArraySelection SelectArray(const std::vector<vtkDataSet*>& blocks, const std::string& name,
  std::optional<Association> where, int component = 0);

/// The array of that name and place in one of the blocks; null if it has none.
vtkDataArray* FindArray(vtkDataSet* block, const ArraySelection& selection);

/// Of what is drawn of the array, over all blocks.
std::array<double, 2> GetRange(
  const std::vector<vtkDataSet*>& blocks, const ArraySelection& selection);

} // namespace tetmarch

#endif
