// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/ComponentImage.h"

#include "Reference/ComponentKernel.h"
#include "Reference/ImageMaker.h"

namespace tetmarch
{
namespace
{

template <typename Kernel, typename Real>
ReferenceImage make(const ReferenceScene& scene, const AccuracyLevel& level)
{
  ImageMaker<Kernel, Real> maker(scene, level);
  maker.kernel().useComponents(*scene.Parts, *scene.Further, scene.Range);
  return maker.make();
}

} // namespace

template <typename Real>
ReferenceImage renderComponents(const ReferenceScene& scene, const AccuracyLevel& level)
{
  const bool ofCells = scene.CellScalars != nullptr;
  switch (scene.Parts->Mix)
  {
    case ComponentMix::Independent:
      return ofCells          ? make<IndependentCellKernel<Real>, Real>(scene, level)
             : level.Adaptive ? make<IndependentPointKernel<Real>, Real>(scene, level)
                              : make<FastIndependentPointKernel<Real>, Real>(scene, level);
    case ComponentMix::ColorAndOpacity:
      return ofCells          ? make<ColorAndOpacityCellKernel<Real>, Real>(scene, level)
             : level.Adaptive ? make<ColorAndOpacityPointKernel<Real>, Real>(scene, level)
                              : make<FastColorAndOpacityPointKernel<Real>, Real>(scene, level);
    default:
      return ofCells          ? make<DirectColorCellKernel<Real>, Real>(scene, level)
             : level.Adaptive ? make<DirectColorPointKernel<Real>, Real>(scene, level)
                              : make<FastDirectColorPointKernel<Real>, Real>(scene, level);
  }
}

template ReferenceImage renderComponents<float>(const ReferenceScene&, const AccuracyLevel&);
template ReferenceImage renderComponents<double>(const ReferenceScene&, const AccuracyLevel&);

} // namespace tetmarch
