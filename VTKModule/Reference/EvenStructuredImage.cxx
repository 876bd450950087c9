// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/ImageGroups.h"
#include "Reference/ImageMaker.h"
#include "Reference/StructuredKernel.h"

namespace tetmarch
{

template <typename Real>
ReferenceImage renderEvenStructured(const ReferenceScene& scene, const AccuracyLevel& level)
{
  return !scene.Effects || scene.Effects->empty()
           ? makeImage<EvenTrilinearKernel, Real>(scene, level)
         : scene.Effects->CellGradients
           ? makeImage<LitEvenTrilinearGradientKernel, Real>(scene, level)
           : makeImage<LitEvenTrilinearKernel, Real>(scene, level);
}

template ReferenceImage renderEvenStructured<float>(const ReferenceScene&, const AccuracyLevel&);
template ReferenceImage renderEvenStructured<double>(const ReferenceScene&, const AccuracyLevel&);

} // namespace tetmarch
