// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/ImageGroups.h"
#include "Reference/ImageMaker.h"
#include "Reference/LitKernel.h"

namespace tetmarch
{

template <typename Real>
ReferenceImage renderLit(const ReferenceScene& scene, const AccuracyLevel& level)
{
  return scene.CellScalars              ? makeImage<LitCellKernel, Real>(scene, level)
         : scene.Effects->CellGradients ? makeImage<LitCellGradientKernel, Real>(scene, level)
         : level.Adaptive               ? makeImage<LitPointKernel, Real>(scene, level)
                                        : makeImage<LitFastPointKernel, Real>(scene, level);
}

template ReferenceImage renderLit<float>(const ReferenceScene&, const AccuracyLevel&);
template ReferenceImage renderLit<double>(const ReferenceScene&, const AccuracyLevel&);

} // namespace tetmarch
