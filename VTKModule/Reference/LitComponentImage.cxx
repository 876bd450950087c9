// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/LitComponentImage.h"

#include "Reference/LitComponentKernel.h"
#include "Reference/LitImageMaker.h"

namespace tetmarch
{
namespace
{

template <typename Kernel, typename Real>
ReferenceImage make(const ReferenceScene& scene, const AccuracyLevel& level)
{
  LitImageMaker<Kernel, Real> maker(scene, level);
  Kernel& kernel = maker.kernel();
  kernel.useComponents(*scene.Parts, *scene.Further, scene.Range);
  // Adaptive pieces that are never tried again are those of a level that isn't adaptive.
  kernel.mostTrials = level.Adaptive ? kernel.mostTrials : 0;
  return maker.make();
}

} // namespace

template <typename Real>
ReferenceImage renderLitComponents(const ReferenceScene& scene, const AccuracyLevel& level)
{
  const bool direct = scene.Parts->Mix == ComponentMix::DirectColor;
  if (scene.CellScalars)
  {
    return direct ? make<LitDirectColorCellKernel<Real>, Real>(scene, level)
                  : make<LitColorAndOpacityCellKernel<Real>, Real>(scene, level);
  }
  if (scene.Effects->CellGradients)
  {
    return direct ? make<LitDirectColorCellGradientKernel<Real>, Real>(scene, level)
                  : make<LitColorAndOpacityCellGradientKernel<Real>, Real>(scene, level);
  }
  return direct ? make<LitDirectColorPointKernel<Real>, Real>(scene, level)
                : make<LitColorAndOpacityPointKernel<Real>, Real>(scene, level);
}

template ReferenceImage renderLitComponents<float>(const ReferenceScene&, const AccuracyLevel&);
template ReferenceImage renderLitComponents<double>(const ReferenceScene&, const AccuracyLevel&);

} // namespace tetmarch
