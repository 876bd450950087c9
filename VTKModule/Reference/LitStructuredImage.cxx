// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/ImageGroups.h"
#include "Reference/ImageMaker.h"
#include "Reference/StructuredKernel.h"

namespace tetmarch
{

template <typename Real>
ReferenceImage renderLitStructured(const ReferenceScene& scene, const AccuracyLevel& level)
{
  return scene.Cells->Constant          ? makeImage<LitConstantKernel, Real>(scene, level)
         : scene.Effects->CellGradients ? makeImage<LitTrilinearGradientKernel, Real>(scene, level)
                                        : makeImage<LitTrilinearKernel, Real>(scene, level);
}

template ReferenceImage renderLitStructured<float>(const ReferenceScene&, const AccuracyLevel&);
template ReferenceImage renderLitStructured<double>(const ReferenceScene&, const AccuracyLevel&);

} // namespace tetmarch
