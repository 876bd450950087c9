// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/ImageGroups.h"
#include "Reference/ImageMaker.h"
#include "Reference/StructuredKernel.h"

namespace tetmarch
{

template <typename Real>
ReferenceImage renderStructured(const ReferenceScene& scene, const AccuracyLevel& level)
{
  return scene.Cells->Constant ? makeImage<ConstantCellKernel, Real>(scene, level)
                               : makeImage<TrilinearKernel, Real>(scene, level);
}

template ReferenceImage renderStructured<float>(const ReferenceScene&, const AccuracyLevel&);
template ReferenceImage renderStructured<double>(const ReferenceScene&, const AccuracyLevel&);

} // namespace tetmarch
