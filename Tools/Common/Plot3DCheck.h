// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What VTK's reader of lists of PLOT3D files takes for granted, and crashes without.
 */
#ifndef tetmarch_Plot3DCheck_h
#define tetmarch_Plot3DCheck_h

#include <string>

namespace tetmarch
{

/// That the list is JSON of the right types, and that its files are there. Throws Failure.
void CheckPlot3D(const std::string& path);

} // namespace tetmarch

#endif
