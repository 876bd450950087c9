// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The frame that the settings of a mapper ask for
 */
#ifndef tetmarch_testing_MapperFrameInput_h
#define tetmarch_testing_MapperFrameInput_h

#include "Mapper/MapperOptions.h"

namespace tetmarch::testing
{
template <typename Mapper>
EffectOptions effectOptionsOf(Mapper* mapper)
{
  const int view = mapper->GetViewMode();
  return { mapper->GetGradientType() == Mapper::CELL_GRADIENTS,
    static_cast<ShadowMethod>(mapper->GetShadowMethod()), mapper->GetVolumetricScatteringBlending(),
    mapper->GetGlobalIlluminationReach(), mapper->GetAmbientOcclusion(),
    mapper->GetAmbientOcclusionRadius(), mapper->GetAmbientOcclusionDirections(),
    mapper->GetOpaqueShadows(),
    view == Mapper::VIEW_ILLUMINATION ? Subject::Illumination
    : view == Mapper::VIEW_GRADIENTS  ? Subject::Gradients
                                      : Subject::Picture,
    static_cast<BlendMode>(mapper->GetBlendMode()),
    static_cast<LightPreset>(mapper->GetLightPreset()), mapper->GetLightTolerance(),
    mapper->GetLightThroughCuts() };
}

template <typename Mapper>
FrameInput frameInputOf(Mapper* mapper, vtkDataSet* data, vtkRenderer* renderer, vtkVolume* volume)
{
  const bool structured = mapper->GetOpacityLaw() == Mapper::STRUCTURED;
  using Law = tetmarch::OpacityLaw;
  return { { { data }, findScalars(data, selectionOf(mapper)), vectorOptionsOf(mapper),
             blendOptionsOf(mapper), clippingOptionsOf(mapper) },
    renderer, volume, structured ? Law::Structured : Law::Unstructured,
    levelOf(static_cast<Accuracy>(mapper->GetAccuracyLevel()), mapper->GetErrorTolerance()),
    mapper->GetDrawNanCells(), effectOptionsOf(mapper) };
}
} // namespace tetmarch::testing

#endif
