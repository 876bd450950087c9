// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The groups of hard cases, a file each
 */
#ifndef tetmarch_testing_HardCaseGroups_h
#define tetmarch_testing_HardCaseGroups_h

#include "HardCase.h"

namespace tetmarch::testing
{
using HardCases = std::vector<HardCase>;

void addRayCases(HardCases& cases);       ///< rays through vertices, along edges, in faces
void addCellCases(HardCases& cases);      ///< slivers, flat, inverted, non-manifold cells
void addScaleCases(HardCases& cases);     ///< scales, offsets, far and wide cameras
void addOpticsCases(HardCases& cases);    ///< scalars and transfer functions
void addNonConvexCases(HardCases& cases); ///< meshes that rays leave and enter again
} // namespace tetmarch::testing

#endif
