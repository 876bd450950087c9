// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state of a view as a script of Python that draws the same picture.
 */
#ifndef tetmarch_PythonScript_h
#define tetmarch_PythonScript_h

#include "ViewState.h"

namespace tetmarch
{

/// structured: the data are images or rectilinear grids. The script opens a window or, if it is
/// given the name of a PNG file, writes the picture.
std::string WriteScript(const ViewState& state, bool structured);

} // namespace tetmarch

#endif
