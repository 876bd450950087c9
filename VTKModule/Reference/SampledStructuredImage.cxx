// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/ImageGroups.h"
#include "Reference/ImageMaker.h"
#include "Reference/StructuredKernel.h"

namespace tetmarch
{

template <typename Real>
ReferenceImage renderSampledStructured(const ReferenceScene& scene, const AccuracyLevel& level)
{
  if (!scene.Effects || scene.Effects->empty())
  {
    return scene.Cells->Constant ? makeImage<SampledConstantKernel, Real>(scene, level)
                                 : makeImage<SampledTrilinearKernel, Real>(scene, level);
  }
  return scene.Cells->Constant ? makeImage<LitSampledConstantKernel, Real>(scene, level)
         : scene.Effects->CellGradients
           ? makeImage<LitSampledTrilinearGradientKernel, Real>(scene, level)
           : makeImage<LitSampledTrilinearKernel, Real>(scene, level);
}

template ReferenceImage renderSampledStructured<float>(const ReferenceScene&, const AccuracyLevel&);
template ReferenceImage renderSampledStructured<double>(
  const ReferenceScene&, const AccuracyLevel&);

} // namespace tetmarch
