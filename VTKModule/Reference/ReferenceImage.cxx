// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/ReferenceImage.h"

#include "Reference/BlendImage.h"
#include "Reference/ComponentImage.h"
#include "Reference/LitComponentImage.h"
#include "Reference/LitImageMaker.h"

namespace tetmarch
{
namespace
{

template <typename Real>
ReferenceImage renderLit(const ReferenceScene& scene, const AccuracyLevel& level)
{
  if (scene.CellScalars)
  {
    return LitImageMaker<LitCellKernel<Real>, Real>(scene, level).make();
  }
  if (scene.Effects->CellGradients)
  {
    return LitImageMaker<LitCellGradientKernel<Real>, Real>(scene, level).make();
  }
  return level.Adaptive ? LitImageMaker<LitPointKernel<Real>, Real>(scene, level).make()
                        : LitImageMaker<LitFastPointKernel<Real>, Real>(scene, level).make();
}

} // namespace

template <typename Real>
ReferenceImage renderReference(const ReferenceScene& scene, const AccuracyLevel& level)
{
  if (scene.Blend && !scene.Blend->isComposite())
  {
    return renderBlended<Real>(scene, level);
  }
  const bool lit = scene.Effects && !scene.Effects->empty();
  if (scene.Parts && !scene.Parts->isSingle())
  {
    return lit ? renderLitComponents<Real>(scene, level) : renderComponents<Real>(scene, level);
  }
  if (lit)
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
