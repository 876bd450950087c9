// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A factor of the opacity that depends on the gradient's magnitude, as a vtkVolumeProperty defines
// it.
#ifndef TetMarchOpticsGradientOpacityTable_h
#define TetMarchOpticsGradientOpacityTable_h

#include <vector>

class vtkVolumeProperty;

namespace tetmarch
{

/** Factors in 0..1. Value i is that of magnitude i * Unit, in scalar units per unit of length of
 * the data. Between values the factor is linear; beyond the last one it is constant. */
struct GradientOpacityTable
{
  static constexpr int Steps = 1024;

  std::vector<float> Values; // Steps + 1
  double Unit = 1;           // above 0

  /** Whether the opacity does not depend on the gradient. */
  bool empty() const { return this->Values.empty(); }
};

/**
 * The function of component 0, evaluated by VTK itself (midpoint, sharpness, clamping), in equal
 * steps from 0 to its last node or to mostMagnitude, the maximum magnitude in the data, whichever
 * is smaller: the function is constant beyond its nodes. If mostMagnitude is not finite, to the
 * last node. The table is empty if there is no such function, or if it is 1 for all of the data.
 *
 * Resolution of 1024 steps: a jump becomes a ramp at most two steps wide, 0.2 % of that range. A
 * peak or a gap between two steps, which equal steps would miss, keeps its height and becomes two
 * steps wide. Of several between the same two steps the most extreme is kept.
 */
GradientOpacityTable gradientOpacityOf(vtkVolumeProperty* property, double mostMagnitude);

} // namespace tetmarch

#endif
