// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "View/RaySamples.h"

#include <cmath>
#include <sstream>

namespace tetmarch
{

std::string describeBadDistance(const RaySamples& samples, const VolumeFrame& frame)
{
  const double least = 2 * frame.Radius / MostSamples;
  if (std::isfinite(samples.Distance) && samples.Distance >= least)
  {
    return {};
  }
  std::ostringstream error;
  error << "The accuracy level is Sampled, but the sample distance is " << samples.Distance
        << ". Set one of " << least
        << " or more (SetSampleDistance()), which is a millionth of the volume's diagonal, a "
           "negative one for half of the spacing, or another accuracy level.";
  return error.str();
}

} // namespace tetmarch
