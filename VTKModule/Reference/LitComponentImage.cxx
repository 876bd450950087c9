// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/ImageGroups.h"
#include "Reference/ImageMaker.h"
#include "Reference/LitComponentKernel.h"

namespace tetmarch
{

template <typename Real>
ReferenceImage renderLitComponents(const ReferenceScene& scene, const AccuracyLevel& level)
{
  const bool direct = scene.Parts->Mix == ComponentMix::DirectColor;
  if (scene.CellScalars)
  {
    return direct ? makeImage<LitDirectColorCellKernel, Real>(scene, level)
                  : makeImage<LitColorAndOpacityCellKernel, Real>(scene, level);
  }
  if (scene.Effects->CellGradients)
  {
    return direct ? makeImage<LitDirectColorCellGradientKernel, Real>(scene, level)
                  : makeImage<LitColorAndOpacityCellGradientKernel, Real>(scene, level);
  }
  return direct ? makeImage<LitDirectColorPointKernel, Real>(scene, level)
                : makeImage<LitColorAndOpacityPointKernel, Real>(scene, level);
}

template ReferenceImage renderLitComponents<float>(const ReferenceScene&, const AccuracyLevel&);
template ReferenceImage renderLitComponents<double>(const ReferenceScene&, const AccuracyLevel&);

} // namespace tetmarch
