// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/ImageGroups.h"
#include "Reference/ImageMaker.h"
#include "Reference/Kernel.h"

namespace tetmarch
{

template <typename Real>
ReferenceImage renderVolume(const ReferenceScene& scene, const AccuracyLevel& level)
{
  return scene.CellScalars ? makeImage<CellKernel, Real>(scene, level)
         : level.Adaptive  ? makeImage<PointKernel, Real>(scene, level)
                           : makeImage<FastPointKernel, Real>(scene, level);
}

template ReferenceImage renderVolume<float>(const ReferenceScene&, const AccuracyLevel&);
template ReferenceImage renderVolume<double>(const ReferenceScene&, const AccuracyLevel&);

} // namespace tetmarch
