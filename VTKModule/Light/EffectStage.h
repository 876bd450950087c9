// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The data of the effects that a scene calls for: each is made again when its own input changed,
// and freed when nothing needs it.
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
  /** Returns an empty string, or what is wrong and what to do; all data is freed then. */
  std::string update(vtkRenderer* renderer, vtkVolume* volume, const EffectOptions& options,
    const EffectInput& input);
  void clear();
  /** The boundary faces of a mesh may have got other numbers since the update. */
  void refreshStarts(const EffectSource& source);

  const EffectData& data() const { return this->Data; }
  /** Set the bits of the key that say which effects there are. If it is left open where shadows are
   * sampled, the number of pixels decides. */
  void setBits(VariantKey& key, double pixels) const;

  /** How often the stages ran: none runs unless something needs it. */
  const StageRecord& gradientsRecord() const { return this->Gradients.record(); }
  const StageRecord& startsRecord() const { return this->Starts.record(); }
  const StageRecord& gradientOpacityRecord() const { return this->GradientOpacity.record(); }
  const StageRecord& opaqueShadowsRecord() const { return this->OpaqueShadows.record(); }
  /** Data of another version has to be uploaded again. */
  const Fingerprint& gradientsVersion() const { return this->Gradients.input(); }
  const Fingerprint& gradientOpacityVersion() const { return this->GradientOpacity.input(); }
  const Fingerprint& startsVersion() const { return this->Starts.input(); }
  /** Changes only if some vertex has come into a shadow or out of one. */
  Fingerprint opaqueShadowsVersion() const;

private:
  void updateGradients(const EffectInput& input, bool needed, bool ofCells);
  void updateGradientOpacity(vtkVolume* volume, const EffectInput& input, bool needed);
  void updateStarts(const EffectSource& source, bool needed);
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
