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
  vtkSmartPointer<vtkDataArray> Array; // its first component is drawn
  Association Where = Association::POINTS;
};

/**
 * The array of the given name; without a name the first floating-point array with one component,
 * else the first with several, else the first of integers, else the first whose values are all
 * equal. Points come before cells unless where says otherwise. Throws Failure that lists what there
 * is.
 */
ArraySelection SelectArray(
  vtkUnstructuredGrid* grid, const std::string& name, std::optional<Association> where);

} // namespace tetmarch

#endif
