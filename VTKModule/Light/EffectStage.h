// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the effects of a scene are made of: only what the scene calls for, made anew when its own
// input changed, and freed when nothing calls for it any more.
#ifndef TetMarchLightEffectStage_h
#define TetMarchLightEffectStage_h

#include "Caching/MadeFrom.h"
#include "Light/EffectData.h"
#include "Light/EffectOptions.h"
#include "Light/EffectSource.h"
#include "Variants/VariantKey.h"

#include <string>

class vtkRenderer;
class vtkVolume;

namespace tetmarch
{

/** What effects are made of. */
struct EffectInput
{
  const EffectSource* Source = nullptr;
  BlockAttributes Blocks = nullptr; // of opaque geometry; nullptr: all of them are drawn alike
};

class EffectStage
{
public:
  /** Returns an empty string, or what is wrong and what to do; nothing is then left. */
  std::string update(vtkRenderer* renderer, vtkVolume* volume, const EffectOptions& options,
    const EffectInput& input);
  void clear();

  const EffectData& data() const { return this->Data; }
  /** The bits of the key that say which effects there are. `pixels` of the picture decide where
   * shadows are looked for, if that is left open. */
  void setBits(VariantKey& key, double pixels) const;

  /** Of gradients and of the starts of rays from vertices: neither runs unless something needs it.
   */
  const StageRecord& gradientsRecord() const { return this->Gradients.record(); }
  const StageRecord& startsRecord() const { return this->Starts.record(); }
  const StageRecord& gradientOpacityRecord() const { return this->GradientOpacity.record(); }
  const StageRecord& opaqueShadowsRecord() const { return this->OpaqueShadows.record(); }
  /** What has changed with these has to be uploaded. */
  const Fingerprint& gradientsVersion() const { return this->Gradients.input(); }
  const Fingerprint& gradientOpacityVersion() const { return this->GradientOpacity.input(); }
  const Fingerprint& startsVersion() const { return this->Starts.input(); }
  /** Another one only if some vertex has come into a shadow or out of one. */
  Fingerprint opaqueShadowsVersion() const;

private:
  void updateGradients(const EffectInput& input, bool needed, bool ofCells);
  void updateGradientOpacity(vtkVolume* volume, const EffectInput& input, bool needed);
  void updateStarts(const EffectInput& input, bool needed);
  void updateOpaqueShadows(vtkRenderer* renderer, vtkVolume* volume, const EffectInput& input);
  bool samplesShadows(double pixels) const;

  EffectOptions Options;
  EffectData Data;
  double SteepestGradient = 0; // in the normalised frame
  MadeFrom Gradients;
  MadeFrom GradientOpacity;
  MadeFrom Starts;
  MadeFrom OpaqueShadows;
  std::uintptr_t DistinctOpaqueShadows = 0;
};

} // namespace tetmarch

#endif
