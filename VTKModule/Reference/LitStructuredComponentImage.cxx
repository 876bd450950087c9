// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/ImageGroups.h"
#include "Reference/ImageMaker.h"
#include "Reference/LitStructuredComponentKernel.h"

namespace tetmarch
{

template <typename Real>
ReferenceImage renderLitStructuredComponents(
  const ReferenceScene& scene, const AccuracyLevel& level)
{
  const bool direct = scene.Parts->Mix == ComponentMix::DirectColor;
  if (scene.Cells->Constant)
  {
    return direct ? makeImage<LitDirectColorConstantKernel, Real>(scene, level)
                  : makeImage<LitColorAndOpacityConstantKernel, Real>(scene, level);
  }
  if (scene.Effects->CellGradients)
  {
    return direct ? makeImage<LitDirectColorTrilinearGradientKernel, Real>(scene, level)
                  : makeImage<LitColorAndOpacityTrilinearGradientKernel, Real>(scene, level);
  }
  return direct ? makeImage<LitDirectColorTrilinearKernel, Real>(scene, level)
                : makeImage<LitColorAndOpacityTrilinearKernel, Real>(scene, level);
}

template ReferenceImage renderLitStructuredComponents<float>(
  const ReferenceScene&, const AccuracyLevel&);
template ReferenceImage renderLitStructuredComponents<double>(
  const ReferenceScene&, const AccuracyLevel&);

} // namespace tetmarch
