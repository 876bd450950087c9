// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/ReferenceImage.h"

#include "Reference/ImageGroups.h"

namespace tetmarch
{

template <typename Real>
ReferenceImage renderReference(const ReferenceScene& scene, const AccuracyLevel& level)
{
  const bool lit = scene.Effects && !scene.Effects->empty();
  if (scene.Blend && !scene.Blend->isComposite())
  {
    return scene.Cells ? renderBlendedStructured<Real>(scene, level)
                       : renderBlended<Real>(scene, level);
  }
  if (scene.Cells && level.Sampled)
  {
    return renderSampledStructured<Real>(scene, level);
  }
  const bool several = scene.Parts && !scene.Parts->isSingle();
  if (scene.Cells && !several && !scene.Cells->Constant && !level.Adaptive)
  {
    return renderEvenStructured<Real>(scene, level);
  }
  if (scene.Cells)
  {
    return several && lit ? renderLitStructuredComponents<Real>(scene, level)
           : several      ? renderStructuredComponents<Real>(scene, level)
           : lit          ? renderLitStructured<Real>(scene, level)
                          : renderStructured<Real>(scene, level);
  }
  if (several)
  {
    return lit ? renderLitComponents<Real>(scene, level) : renderComponents<Real>(scene, level);
  }
  return lit ? renderLit<Real>(scene, level) : renderVolume<Real>(scene, level);
}

template ReferenceImage renderReference<float>(const ReferenceScene&, const AccuracyLevel&);
template ReferenceImage renderReference<double>(const ReferenceScene&, const AccuracyLevel&);

} // namespace tetmarch
