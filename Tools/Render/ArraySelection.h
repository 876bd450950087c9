// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which array of the grid is drawn.
 */
#ifndef tetmarch_ArraySelection_h
#define tetmarch_ArraySelection_h

#include "CommandLine.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

class vtkUnstructuredGrid;

namespace tetmarch
{

struct ArraySelection
{
  vtkSmartPointer<vtkDataArray> Array;
  Association Where = Association::POINTS;
  int Component = 0; // that is drawn, as vtkDataArray::GetRange() has it: -1 is the magnitude
};

/**
 * The array of the given name; without a name the first floating-point array with one component,
 * else the first with several, else the first of integers, else the first whose values are all
 * equal. Points come before cells unless where says otherwise. Throws Failure that lists what there
 * is, or says how many components there are. The magnitude of a single one is itself.
 */
ArraySelection SelectArray(vtkUnstructuredGrid* grid, const std::string& name,
  std::optional<Association> where, int component = 0);

} // namespace tetmarch

#endif
