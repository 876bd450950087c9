// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Named transfer functions of images, by VTK's law of opacity
 */
#ifndef tetmarch_bench_StructuredFunctions_h
#define tetmarch_bench_StructuredFunctions_h

#include "Functions.h"

namespace tetmarch::bench
{
/**
 * "ramp": nothing below a tenth of the range, then from cool to warm, opacity up to 0.9. "peaks":
 * five triangular peaks, each half a hundredth of the range to either side. "smooth": hue and
 * opacity go up and down as cosines, and nothing is transparent. Opacities stay below 1, where the
 * extinction has no bound.
 */
bool isStructuredFunctions(const std::string& name);
const std::vector<std::string>& structuredFunctions();
vtkSmartPointer<vtkVolumeProperty> makeStructuredFunctions(
  const std::string& name, const FunctionRange& range);
} // namespace tetmarch::bench

#endif
