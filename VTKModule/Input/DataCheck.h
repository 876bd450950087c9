// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether a data set can be read. All that read one ask this before: mapper, first picture, tools.
#ifndef TetMarchInputDataCheck_h
#define TetMarchInputDataCheck_h

#include <string>

class vtkDataSet;

namespace tetmarch
{

/**
 * Returns an empty string, or what is wrong with the points and the cells of the data, and what to
 * do. Data without cells is sound. Checked are unstructured grids (checkGrid), images and
 * rectilinear grids (readGeometry, findFrame), curvilinear and explicit structured grids; of the
 * last two ghost arrays as well. Arrays of values are checked when they are chosen (checkTuples).
 *
 * The verdicts on unstructured grids are remembered for grids that were not modified since, so that
 * it costs little to ask again. Can be called in any thread.
 */
std::string checkData(vtkDataSet* data);

/** Whether ghost arrays have one value for each cell or point. Of data whose cells VTK computes it
 * reads them with each cell's type. */
std::string checkGhosts(vtkDataSet* data);

} // namespace tetmarch

#endif
