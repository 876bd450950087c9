// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Gradients in half of the memory: sixteen bits a component.
#ifndef TetMarchMeshHalfFloats_h
#define TetMarchMeshHalfFloats_h

#include "Mesh/Gradients.h"

namespace tetmarch
{

/**
 * The nearest number of IEEE 754 binary16, of two the even one. What is too large for it, infinity
 * too, becomes the largest finite one; what is not a number stays none.
 */
std::uint16_t toHalf(float value);

/** A gradient is Unit times the first three components of its texel; the fourth is 0. */
struct PackedGradients
{
  std::vector<std::array<std::uint16_t, 4>> Texels;
  double Unit = 1;
};

/**
 * One unit for all, such that the largest component is about 60000: components down to a billionth
 * of it keep eleven bits, smaller ones fade out. Directions are off by 0.03 degrees at most.
 */
PackedGradients packGradients(const std::vector<Gradient>& gradients);

} // namespace tetmarch

#endif
