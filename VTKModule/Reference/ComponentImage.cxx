// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/ComponentKernel.h"
#include "Reference/ImageGroups.h"
#include "Reference/ImageMaker.h"

namespace tetmarch
{

template <typename Real>
ReferenceImage renderComponents(const ReferenceScene& scene, const AccuracyLevel& level)
{
  const bool ofCells = scene.CellScalars != nullptr;
  switch (scene.Parts->Mix)
  {
    case ComponentMix::Independent:
      return ofCells          ? makeImage<IndependentCellKernel, Real>(scene, level)
             : level.Adaptive ? makeImage<IndependentPointKernel, Real>(scene, level)
                              : makeImage<FastIndependentPointKernel, Real>(scene, level);
    case ComponentMix::ColorAndOpacity:
      return ofCells          ? makeImage<ColorAndOpacityCellKernel, Real>(scene, level)
             : level.Adaptive ? makeImage<ColorAndOpacityPointKernel, Real>(scene, level)
                              : makeImage<FastColorAndOpacityPointKernel, Real>(scene, level);
    default:
      return ofCells          ? makeImage<DirectColorCellKernel, Real>(scene, level)
             : level.Adaptive ? makeImage<DirectColorPointKernel, Real>(scene, level)
                              : makeImage<FastDirectColorPointKernel, Real>(scene, level);
  }
}

template ReferenceImage renderComponents<float>(const ReferenceScene&, const AccuracyLevel&);
template ReferenceImage renderComponents<double>(const ReferenceScene&, const AccuracyLevel&);

} // namespace tetmarch
