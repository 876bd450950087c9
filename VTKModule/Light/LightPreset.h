// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Light with a name: lights, reflection and effects that go together, in place of the scene's.
#ifndef TetMarchLightLightPreset_h
#define TetMarchLightLightPreset_h

#include "Light/EffectOptions.h"
#include "Light/Lighting.h"

namespace tetmarch
{

/** The lights and the reflection of a preset other than OfScene. Those of Studio and Headlight go
 * with the camera; that of Sun stays in the world, above the axis nearest to the view up. */
Lighting presetLighting(LightPreset preset, vtkRenderer* renderer);

/** With the shadows and the occlusion of the preset, if these are off. */
EffectOptions withPreset(EffectOptions options);

} // namespace tetmarch

#endif
