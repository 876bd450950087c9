// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The colours that rays see in a hard case are colours; that they are right is for
 * PictureCheck.h
 */
#ifndef tetmarch_testing_ColourCheck_h
#define tetmarch_testing_ColourCheck_h

#include "MarchedCase.h"
#include "RayTotals.h"

#include "Reference/Kernel.h"
#include "Reference/MakeKernel.h"

#include "RandomRays.h"

#include <algorithm>
#include <sstream>

namespace tetmarch::testing
{
/// Finite colours and transmittances, whatever the scalars and functions.
template <typename Kernel>
class ColourCheck
{
public:
  ColourCheck(const MarchedCase& check, unsigned seed)
    : Check(check)
    , March(makeKernel<Kernel, float>(check.Mesh, check.Table, check.Range, DefaultAccuracy))
    , Random(seed)
  {
    this->March.CellScalars = check.CellScalars.data();
  }

  RayTotals run(int rays)
  {
    const auto perUnit = static_cast<float>(std::min(1.0 / this->Check.UnitDistance, 1e15));
    RayTotals totals;
    for (int i = 0; i < rays; ++i)
    {
      const auto ray = this->Random.template next<Kernel, float>(this->March, this->Check.Mesh);
      const auto marched = this->March.castPlainRay(ray, perUnit, -3e38f, 3e38f);
      const auto& c = marched.radiance.color;
      const float t = marched.radiance.transmittance;
      const auto inRange = [](float x) { return x >= -1e-6f && x <= 1.0f + 1e-5f; };
      const bool sound = inRange(c.x) && inRange(c.y) && inRange(c.z) && inRange(t);
      ++totals.Rays;
      totals.Met += marched.cells > 0;
      totals.Lost += marched.lost;
      totals.Guarded += marched.guarded;
      totals.Refused += marched.refused;
      totals.NotFinite += sound ? 0 : 1;
      if (!sound && totals.FirstFailure.empty())
      {
        std::ostringstream text;
        text << "ray " << i << ": colour " << c.x << ' ' << c.y << ' ' << c.z << ", transmittance "
             << t;
        totals.FirstFailure = text.str();
      }
    }
    return totals;
  }

private:
  const MarchedCase& Check;
  Kernel March;
  RandomRays Random;
};
} // namespace tetmarch::testing

#endif
