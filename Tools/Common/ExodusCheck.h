// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What VTK's reader of Exodus takes for granted, and crashes without.
 */
#ifndef tetmarch_ExodusCheck_h
#define tetmarch_ExodusCheck_h

#include <string>

namespace tetmarch
{

/// Sizes, and the points of cells, of files in the classic format of netCDF; those in HDF5 are not
/// looked into. Throws Failure.
void CheckExodus(const std::string& path);

} // namespace tetmarch

#endif
