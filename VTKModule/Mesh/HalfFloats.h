// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Gradients as half floats: 16 bits per component.
#ifndef TetMarchMeshHalfFloats_h
#define TetMarchMeshHalfFloats_h

#include "Mesh/Gradients.h"

namespace tetmarch
{

/** The nearest number of IEEE 754 binary16, ties to even. Numbers out of range and infinities
 * become the largest finite ones. NaN stays NaN. */
std::uint16_t toHalf(float value);

/** A gradient is Unit times the first three components of its texel; the fourth is 0. */
struct PackedGradients
{
  std::vector<std::array<std::uint16_t, 4>> Texels;
  double Unit = 1;
};

/**
 * All gradients share one unit, such that the largest component is about 60000. Components down to
 * a billionth of the largest keep eleven bits, smaller ones lose digits gradually. The error of
 * directions is at most 0.03 degrees.
 */
PackedGradients packGradients(const std::vector<Gradient>& gradients);

} // namespace tetmarch

#endif
