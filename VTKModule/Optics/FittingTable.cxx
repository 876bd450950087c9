// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FittingTable.h"

namespace tetmarch
{

IntegralTable fittingTable(
  vtkVolumeProperty* property, OpacityLaw law, double low, double high, const AccuracyLevel& level)
{
  int perBin = 16; // fine samples
  const int bins = samplesOfTable(level.LeastTableEntries) - 1;
  const int mostBins = samplesOfTable(level.MostTableEntries) - 1;
  SampledFunctions fine = sampleFunctions(property, law, low, high, bins * perBin + 1);
  SampledFunctions kept = keepAreas(fine, perBin);
  while (kept.Deviation > 0.5 * level.ErrorTolerance &&
         static_cast<int>(kept.Samples.size() - 1) * 4 <= mostBins)
  {
    if (perBin == 4)
    {
      fine = refined(property, law, fine, 4);
      perBin = 16;
    }
    perBin /= 4;
    kept = keepAreas(fine, perBin);
  }
  return makeIntegralTable(kept);
}

} // namespace tetmarch
