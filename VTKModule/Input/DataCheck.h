// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Validation of data sets, before mapper, first picture and tools read them.
#ifndef TetMarchInputDataCheck_h
#define TetMarchInputDataCheck_h

#include <string>

class vtkDataSet;

namespace tetmarch
{

/**
 * Returns an empty string, or an error of the points or the cells of the data, with its remedy.
 * Data without cells are valid. It checks unstructured grids (checkGrid), images and rectilinear
 * grids (readGeometry, findFrame), curvilinear and explicit structured grids, and the ghost arrays
 * of the last two. Arrays of values are checked when they are chosen (checkTuples).
 *
 * Results for unstructured grids are cached until the grid is modified, so that repeated calls cost
 * little. Can be called in any thread.
 */
std::string checkData(vtkDataSet* data);

/** Whether ghost arrays have one value for each cell or point. For data whose cells VTK computes,
 * it reads them with each cell's type. */
std::string checkGhosts(vtkDataSet* data);

} // namespace tetmarch

#endif
