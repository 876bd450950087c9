// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/ImageGroups.h"
#include "Reference/ImageMaker.h"
#include "Reference/StructuredKernel.h"

namespace tetmarch
{

namespace
{

template <typename Real>
ReferenceImage renderIsosurfaces(const ReferenceScene& scene, const AccuracyLevel& level)
{
  const bool lit = scene.Effects && !scene.Effects->Lights.Sources.empty();
  if (scene.Cells->Constant)
  {
    return lit ? makeImage<LitIsosurfaceConstantKernel, Real>(scene, level)
               : makeImage<IsosurfaceConstantKernel, Real>(scene, level);
  }
  return !lit ? makeImage<IsosurfaceTrilinearKernel, Real>(scene, level)
         : scene.Effects->CellGradients
           ? makeImage<LitIsosurfaceTrilinearGradientKernel, Real>(scene, level)
           : makeImage<LitIsosurfaceTrilinearKernel, Real>(scene, level);
}

} // namespace

template <typename Real>
ReferenceImage renderBlendedStructured(const ReferenceScene& scene, const AccuracyLevel& level)
{
  if (scene.Blend->isIsoSurface())
  {
    return renderIsosurfaces<Real>(scene, level);
  }
  const bool constant = scene.Cells->Constant;
  if (scene.Blend->isSum())
  {
    return constant ? makeImage<SumConstantKernel, Real>(scene, level)
                    : makeImage<SumTrilinearKernel, Real>(scene, level);
  }
  return constant ? makeImage<ExtremeConstantKernel, Real>(scene, level)
                  : makeImage<ExtremeTrilinearKernel, Real>(scene, level);
}

template ReferenceImage renderBlendedStructured<float>(const ReferenceScene&, const AccuracyLevel&);
template ReferenceImage renderBlendedStructured<double>(
  const ReferenceScene&, const AccuracyLevel&);

} // namespace tetmarch
