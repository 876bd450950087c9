// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/BlendKernel.h"
#include "Reference/ImageGroups.h"
#include "Reference/ImageMaker.h"

namespace tetmarch
{

namespace
{

template <typename Real>
ReferenceImage renderIsosurfaces(const ReferenceScene& scene, const AccuracyLevel& level)
{
  const bool lit = scene.Effects && !scene.Effects->Lights.Sources.empty();
  if (scene.CellScalars)
  {
    return lit ? makeImage<LitIsosurfaceCellKernel, Real>(scene, level)
               : makeImage<IsosurfaceCellKernel, Real>(scene, level);
  }
  return !lit                           ? makeImage<IsosurfacePointKernel, Real>(scene, level)
         : scene.Effects->CellGradients ? makeImage<LitIsosurfaceGradientKernel, Real>(scene, level)
                                        : makeImage<LitIsosurfacePointKernel, Real>(scene, level);
}

} // namespace

template <typename Real>
ReferenceImage renderBlended(const ReferenceScene& scene, const AccuracyLevel& level)
{
  if (scene.Blend->isIsoSurface())
  {
    return renderIsosurfaces<Real>(scene, level);
  }
  if (scene.Blend->isSum())
  {
    return scene.CellScalars ? makeImage<SumCellKernel, Real>(scene, level)
                             : makeImage<SumPointKernel, Real>(scene, level);
  }
  return scene.CellScalars ? makeImage<ExtremeCellKernel, Real>(scene, level)
                           : makeImage<ExtremePointKernel, Real>(scene, level);
}

template ReferenceImage renderBlended<float>(const ReferenceScene&, const AccuracyLevel&);
template ReferenceImage renderBlended<double>(const ReferenceScene&, const AccuracyLevel&);

} // namespace tetmarch
