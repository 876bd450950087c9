// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The colour maps that the programs know by name. Of each, lightness rises or falls all the way, or
 * up to the middle and back, so that it tells the order of scalars to any eye. ColorMaps.json has
 * their points, make_color_maps.py where they come from.
 */
#ifndef tetmarch_ColorMaps_h
#define tetmarch_ColorMaps_h

#include <string>
#include <vector>

class vtkColorTransferFunction;

namespace tetmarch
{

std::vector<std::string> GetColorMapNames();

/**
 * Gives a function the points and the colour space of a map, from low to high, and its colour of
 * NaN. A function with a logarithmic scale keeps it if low is above 0. If low and high are equal,
 * all of the function is the colour in the middle of the map.
 *
 * Of the name, case, blanks and "(matplotlib)" don't count. Returns false, and leaves the function
 * as it is, if there is no such map. Throws Failure if low or high isn't finite.
 */
bool ApplyColorMap(
  const std::string& name, double low, double high, vtkColorTransferFunction* color);

/// What to tell somebody who asked for a map that isn't there: its name, and those that are.
std::string DescribeUnknownColorMap(const std::string& name);

} // namespace tetmarch

#endif
