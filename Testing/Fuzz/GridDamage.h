// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Damage to the arrays of a grid: cut short, made longer, or with another value somewhere
 */
#ifndef tetmarch_testing_GridDamage_h
#define tetmarch_testing_GridDamage_h

#include "ByteReader.h"
#include "RawGrid.h"

namespace tetmarch::testing
{
void damage(ByteReader& reader, RawGrid& raw);
} // namespace tetmarch::testing

#endif
