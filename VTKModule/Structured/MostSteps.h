// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Maximum number of steps of a ray through a lattice.
#ifndef TetMarchStructuredMostSteps_h
#define TetMarchStructuredMostSteps_h

#include "Structured/Lattice.h"

namespace tetmarch
{

/** Each cell on a ray has up to nine parts (Shaders/structured/cross_cell.glsl). A march that
 * exceeds this is wrong and ends. */
inline int mostStepsOf(const Lattice& lattice)
{
  constexpr int MostParts = 9;
  const int cells = mostCellsOf(lattice);
  return cells < 0x7fffffff / MostParts ? cells * MostParts : 0x7fffffff;
}

} // namespace tetmarch

#endif
