// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/CellKernel.h"
#include "Reference/PointKernel.h"
#include "Reference/PortablePointKernel.h"

#include "MarchCheck.h"

#include "ColourCheck.h"
#include "LengthCheck.h"

namespace tetmarch::testing
{
RayTotals MarchCheck::run(unsigned chunk, int rays) const
{
  if (this->March.Mesh.Tets.empty())
  {
    return {};
  }
  const unsigned seed = 2654435761u * (chunk + 1);
  const bool fused = chunk % 2 == 0;
  if (!this->March.CellScalars.empty())
  {
    return ColourCheck<CellKernel<float>>(this->March, seed).run(rays);
  }
  if (this->March.Case.Group == "optics")
  {
    return fused ? ColourCheck<PointKernel<float>>(this->March, seed).run(rays)
                 : ColourCheck<PortablePointKernel<float>>(this->March, seed).run(rays);
  }
  return fused ? LengthCheck<PointKernel<float>>(this->March, seed).run(rays)
               : LengthCheck<PortablePointKernel<float>>(this->March, seed).run(rays);
}
} // namespace tetmarch::testing
