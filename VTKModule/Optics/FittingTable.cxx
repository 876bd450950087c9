// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Optics/FittingTable.h"

#include <algorithm>

namespace tetmarch
{

IntegralTable fittingTable(
  vtkVolumeProperty* property, OpacityLaw law, double low, double high, const AccuracyLevel& level)
{
  // The number of samples of colours, which are expensive, does not depend on the level.
  const int mostPerBin = std::max(4, 16384 / level.LeastTableEntries);
  constexpr int leastPerBin = 2;
  const double most = 0.5 * level.ErrorTolerance;
  const int leastBins = samplesOfTable(level.LeastTableEntries) - 1;
  const int mostBins = samplesOfTable(level.MostTableEntries) - 1;
  SampledFunctions fine = sampleFunctions(property, law, low, high, leastBins * mostPerBin + 1);
  int bins = leastBins;
  SampledFunctions kept = keepAreas(fine, mostPerBin);
  while (kept.Deviation > most && bins * 4 <= mostBins)
  {
    // At a kink the deviation is proportional to the width of a bin: insufficient sizes are
    // skipped.
    bins *= kept.Deviation > 8 * most && bins * 16 <= mostBins ? 16 : 4;
    const int fineBins = static_cast<int>(fine.Samples.size()) - 1;
    if (fineBins < leastPerBin * bins)
    {
      fine = refined(property, law, fine, leastPerBin * bins / fineBins);
    }
    kept = keepAreas(fine, (static_cast<int>(fine.Samples.size()) - 1) / bins);
  }
  IntegralTable table = makeIntegralTable(kept);
  table.NanColor = nanColorOf(property, law);
  return table;
}

} // namespace tetmarch
