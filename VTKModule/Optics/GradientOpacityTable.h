// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The factor of opacity that follows from the gradient's magnitude, as a vtkVolumeProperty has it.
#ifndef TetMarchOpticsGradientOpacityTable_h
#define TetMarchOpticsGradientOpacityTable_h

#include <vector>

class vtkVolumeProperty;

namespace tetmarch
{

/**
 * Factors in 0..1; value i is that of magnitude i * Unit, in scalar units per unit of length of the
 * data's coordinates. Beyond the last value, it holds. Between values they are read linearly.
 */
struct GradientOpacityTable
{
  static constexpr int Steps = 1024;

  std::vector<float> Values; // Steps + 1
  double Unit = 1;           // above 0

  /** Nothing depends on the gradient. */
  bool empty() const { return this->Values.empty(); }
};

/**
 * The function of component 0, evaluated by VTK itself (midpoint, sharpness, clamping), in equal
 * steps from 0 to its last node or to mostMagnitude, the greatest of the data, whichever is less:
 * beyond its nodes a function is constant, and the steps are spent where something happens. If
 * mostMagnitude is no finite number, to the last node. Empty if there is no such function or it is
 * 1 for all of the data.
 *
 * What 1024 steps resolve: a jump is a ramp at most two steps wide, 0.2 % of that range, wherever
 * it is. A peak or a gap between two steps, which the steps alone would miss, keeps its height and
 * is as wide as two of them. Several between the same two steps are one: that which stands out
 * most.
 */
GradientOpacityTable gradientOpacityOf(vtkVolumeProperty* property, double mostMagnitude);

} // namespace tetmarch

#endif
