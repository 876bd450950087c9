// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief All that is done with a grid before the GL sees it, and what must hold
 */
#ifndef tetmarch_testing_Exercise_h
#define tetmarch_testing_Exercise_h

#include "GridCode.h"

#include <string>

namespace tetmarch::testing
{
/// Decode, build, march. The error that the grid was refused with; empty if rays were marched
/// through it. Aborts with a message if links don't lead back, a ray is lost, guarded or refused,
/// or a pixel isn't finite.
std::string exercise(const Bytes& bytes);
} // namespace tetmarch::testing

#endif
