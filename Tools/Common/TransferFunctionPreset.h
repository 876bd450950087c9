// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Transfer functions in the JSON format in which ParaView exports its colour map presets: an array
 * of objects, of which the first is taken, or an object alone. Its fields:
 *
 * - Name
 * - ColorSpace: RGB, HSV, Lab, CIELAB, Diverging, Lab/CIEDE2000 or Step
 * - HSVWrap, UseLogScale
 * - RGBPoints: [x, r, g, b, ...], required
 * - RGBPointsShape: [midpoint, sharpness, ...] of the colour points. ParaView has no such field and
 *   ignores it; without it they are 0.5 and 0
 * - Points: [x, opacity, midpoint, sharpness, ...]; without it the opacity rises linearly from 0 to
 *   1 over the range of the colours
 * - NanColor: [r, g, b]
 *
 * Other fields are ignored. Presets of indexed colours are refused.
 */
#ifndef tetmarch_TransferFunctionPreset_h
#define tetmarch_TransferFunctionPreset_h

#include "TransferFunctions.h"

#include <array>
#include <optional>
#include <string>

namespace tetmarch
{

/**
 * If range is given, both functions are stretched so that the colour points span it. Throws Failure
 * that names the field or the line at fault; name is what the message calls the text.
 */
TransferFunctions ParsePreset(const std::string& text, const std::string& name,
  const std::optional<std::array<double, 2>>& range = std::nullopt);

/// The same from a file.
TransferFunctions ReadPreset(
  const std::string& path, const std::optional<std::array<double, 2>>& range = std::nullopt);

/**
 * Writes both functions as a preset that ReadPreset() and ParaView take. Throws Failure if the file
 * can't be written or a function has no points; an older file is then left as it was.
 */
void WritePreset(const std::string& path, const std::string& name, vtkColorTransferFunction* color,
  vtkPiecewiseFunction* opacity);

} // namespace tetmarch

#endif
