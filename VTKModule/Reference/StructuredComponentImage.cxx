// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/ImageGroups.h"
#include "Reference/ImageMaker.h"
#include "Reference/StructuredComponentKernel.h"

namespace tetmarch
{

template <typename Real>
ReferenceImage renderStructuredComponents(const ReferenceScene& scene, const AccuracyLevel& level)
{
  const bool constant = scene.Cells->Constant;
  switch (scene.Parts->Mix)
  {
    case ComponentMix::Independent:
      return constant ? makeImage<IndependentConstantKernel, Real>(scene, level)
                      : makeImage<IndependentTrilinearKernel, Real>(scene, level);
    case ComponentMix::ColorAndOpacity:
      return constant ? makeImage<ColorAndOpacityConstantKernel, Real>(scene, level)
                      : makeImage<ColorAndOpacityTrilinearKernel, Real>(scene, level);
    default:
      return constant ? makeImage<DirectColorConstantKernel, Real>(scene, level)
                      : makeImage<DirectColorTrilinearKernel, Real>(scene, level);
  }
}

template ReferenceImage renderStructuredComponents<float>(
  const ReferenceScene&, const AccuracyLevel&);
template ReferenceImage renderStructuredComponents<double>(
  const ReferenceScene&, const AccuracyLevel&);

} // namespace tetmarch
