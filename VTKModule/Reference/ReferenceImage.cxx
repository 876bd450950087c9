// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceImage.h"

#include "BlendImage.h"
#include "ComponentImage.h"
#include "ImageMaker.h"
#include "LitKernel.h"
#include "VolumeLight.h"

namespace tetmarch
{
namespace
{

template <typename Kernel, typename Real>
ReferenceImage makeLit(const ReferenceScene& scene, const AccuracyLevel& level)
{
  ImageMaker<Kernel, Real> maker(scene, level);
  Kernel& kernel = maker.kernel();
  kernel.useEffects(*scene.Effects);
  const bool throughVolume = scene.Effects->Lights.hasVolumeLight();
  std::unique_ptr<IncomingLight<Real>> exact;
  std::vector<Real> atVertices;
  if (throughVolume && scene.ExactLight)
  {
    exact = exactLight<Real>(scene);
  }
  else if (throughVolume)
  {
    atVertices = lightAtVertices<Real>(scene);
  }
  kernel.Incoming = exact.get();
  kernel.VertexLight = atVertices.empty() ? nullptr : atVertices.data();
  return maker.make();
}

template <typename Real>
ReferenceImage renderLit(const ReferenceScene& scene, const AccuracyLevel& level)
{
  if (scene.CellScalars)
  {
    return makeLit<LitCellKernel<Real>, Real>(scene, level);
  }
  if (scene.Effects->CellGradients)
  {
    return makeLit<LitCellGradientKernel<Real>, Real>(scene, level);
  }
  return level.Adaptive ? makeLit<LitPointKernel<Real>, Real>(scene, level)
                        : makeLit<LitFastPointKernel<Real>, Real>(scene, level);
}

} // namespace

template <typename Real>
ReferenceImage renderReference(const ReferenceScene& scene, const AccuracyLevel& level)
{
  if (scene.Blend && !scene.Blend->isComposite())
  {
    return renderBlended<Real>(scene, level);
  }
  if (scene.Parts && !scene.Parts->isSingle())
  {
    return renderComponents<Real>(scene, level);
  }
  if (scene.Effects && !scene.Effects->empty())
  {
    return renderLit<Real>(scene, level);
  }
  if (scene.CellScalars)
  {
    return ImageMaker<CellKernel<Real>, Real>(scene, level).make();
  }
  return level.Adaptive ? ImageMaker<PointKernel<Real>, Real>(scene, level).make()
                        : ImageMaker<FastPointKernel<Real>, Real>(scene, level).make();
}

template ReferenceImage renderReference<float>(const ReferenceScene&, const AccuracyLevel&);
template ReferenceImage renderReference<double>(const ReferenceScene&, const AccuracyLevel&);

} // namespace tetmarch
