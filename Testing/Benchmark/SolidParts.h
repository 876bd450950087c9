// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Solid parts as engineers mesh them: rims, folds, an axle, with air between
 */
#ifndef tetmarch_bench_SolidParts_h
#define tetmarch_bench_SolidParts_h

#include "Datasets.h"

namespace tetmarch::bench
{
bool isSolidPart(const std::string& name);
/// The file that it is made of.
std::string pathOfSolidPart(const std::string& name, const DataFolders& folders);
/// Finer tetrahedra than the file's, with waves of our own, since only one of the files has an
/// array that shows something. Throws Failure if the file can't be read.
Dataset readSolidPart(const std::string& name, const DataFolders& folders);
} // namespace tetmarch::bench

#endif
