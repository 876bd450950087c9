// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Named transfer functions over any range of scalars
 */
#ifndef tetmarch_bench_Functions_h
#define tetmarch_bench_Functions_h

#include "TransferFunctions.h"

#include "vtkSmartPointer.h"
#include "vtkVolumeProperty.h"

#include <string>
#include <vector>

namespace tetmarch::bench
{
/// The one that each dataset has of its own.
extern const std::string OwnFunctions;

/// What a dataset asks of functions that aren't its own.
struct FunctionRange
{
  double Low;
  double High;
  double UnitDistance; // in which something of opacity 1 has an optical depth of 1
};

/**
 * "smooth": hue and opacity go up and down as cosines. "ramp": ParaView's colours from cool to
 * warm, opacity from 0 to 1. "spikes": five triangular peaks, each half a hundredth of the range to
 * either side and ten times as dense, in five colours.
 */
bool isFunctions(const std::string& name);
const std::vector<std::string>& commonFunctions();

/// Any but OwnFunctions.
vtkSmartPointer<vtkVolumeProperty> makeFunctions(
  const std::string& name, const FunctionRange& range);

vtkSmartPointer<vtkVolumeProperty> propertyOf(const TransferFunctions& functions, double unit);

/// For scalars from 0 to 1: translucent throughout, so that no ray may end early. Four unit
/// distances absorb about three quarters of the light.
vtkSmartPointer<vtkVolumeProperty> wavesProperty(double unitDistance);
} // namespace tetmarch::bench

#endif
