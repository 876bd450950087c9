// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/BlendImage.h"

#include "Reference/BlendKernel.h"
#include "Reference/ImageMaker.h"

namespace tetmarch
{
namespace
{

template <typename Kernel, typename Real>
ReferenceImage make(const ReferenceScene& scene, const AccuracyLevel& level)
{
  ImageMaker<Kernel, Real> maker(scene, level);
  maker.kernel().useBlending(*scene.Blend);
  return maker.make();
}

template <typename Kernel, typename Real>
ReferenceImage makeLit(const ReferenceScene& scene, const AccuracyLevel& level)
{
  ImageMaker<Kernel, Real> maker(scene, level);
  maker.kernel().useBlending(*scene.Blend);
  maker.kernel().useEffects(*scene.Effects);
  return maker.make();
}

template <typename Real>
ReferenceImage renderIsosurfaces(const ReferenceScene& scene, const AccuracyLevel& level)
{
  const bool lit = scene.Effects && !scene.Effects->Lights.Sources.empty();
  if (scene.CellScalars)
  {
    return lit ? makeLit<LitIsosurfaceCellKernel<Real>, Real>(scene, level)
               : make<IsosurfaceCellKernel<Real>, Real>(scene, level);
  }
  if (!lit)
  {
    return make<IsosurfacePointKernel<Real>, Real>(scene, level);
  }
  return scene.Effects->CellGradients
           ? makeLit<LitIsosurfaceGradientKernel<Real>, Real>(scene, level)
           : makeLit<LitIsosurfacePointKernel<Real>, Real>(scene, level);
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
    return scene.CellScalars ? make<SumCellKernel<Real>, Real>(scene, level)
                             : make<SumPointKernel<Real>, Real>(scene, level);
  }
  return scene.CellScalars ? make<ExtremeCellKernel<Real>, Real>(scene, level)
                           : make<ExtremePointKernel<Real>, Real>(scene, level);
}

template ReferenceImage renderBlended<float>(const ReferenceScene&, const AccuracyLevel&);
template ReferenceImage renderBlended<double>(const ReferenceScene&, const AccuracyLevel&);

} // namespace tetmarch
