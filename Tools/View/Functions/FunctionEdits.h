// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the editor's buttons do to the functions.
 */
#ifndef tetmarch_FunctionEdits_h
#define tetmarch_FunctionEdits_h

#include "FunctionSnapshot.h"

namespace tetmarch
{

/// The colours from right to left over the same range, with the curves between their points.
FunctionSnapshot InvertColors(FunctionSnapshot state);

/// Stretches the colours to span low to high, and the opacities, by themselves, likewise.
FunctionSnapshot FitToRange(FunctionSnapshot state, double low, double high);

} // namespace tetmarch

#endif
