// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What of the volume the user wants to be cut away.
 */
#ifndef tetmarch_CutOptions_h
#define tetmarch_CutOptions_h

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tetmarch
{
class AnyMapper;

struct ClippingPlaneOption
{
  std::array<double, 3> Origin;
  std::array<double, 3> Normal; // towards what is left
};

struct CutOptions
{
  std::vector<ClippingPlaneOption> Planes;
  std::optional<std::array<double, 6>> Crop; // xmin, xmax, ymin, ymax, zmin, zmax
  int CropRegions = 0;                       // the place among the words of --crop-regions
};

/// Each throws UsageError.
ClippingPlaneOption ParseClippingPlane(const std::string& value);
std::array<double, 6> ParseCrop(const std::string& value);

void SetUpCuts(const CutOptions& options, AnyMapper& mapper);

} // namespace tetmarch

#endif
