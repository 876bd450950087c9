// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The data of a scene's effects: each is updated when its input has changed, and freed when it is
// not needed.
#ifndef TetMarchLightEffectStage_h
#define TetMarchLightEffectStage_h

#include "Caching/CachedStage.h"
#include "Light/EffectData.h"
#include "Light/EffectOptions.h"
#include "Light/EffectSource.h"
#include "Variants/VariantKey.h"

#include <string>

class vtkRenderer;
class vtkVolume;
class vtkVolumeProperty;

namespace tetmarch
{

/** The input of the effects. */
struct EffectInput
{
  const EffectSource* Source = nullptr;
  BlockAttributes Blocks = nullptr; // of opaque geometry; nullptr: all blocks are drawn alike
  /** These have pieces of the volume; nullptr: there is one process. Gradients are then found by
   * all of them or by none: the generation changes in all if the scalars of one have changed. */
  Group* Processes = nullptr;
  std::uintptr_t Generation = 0;
  bool OfComponents = false; // independent ones have a gradient each
};

/** Whether the picture may need gradients. */
bool mayHaveGradients(vtkVolumeProperty* property, const EffectOptions& options);

class EffectStage
{
public:
  /** Returns an empty string, or an error with its remedy; all data are then freed. */
  std::string update(vtkRenderer* renderer, vtkVolume* volume, const EffectOptions& options,
    const EffectInput& input);
  void clear();
  /** Call this after the boundary faces of a mesh were reordered. */
  void refreshStarts(const EffectSource& source);

  const EffectData& data() const { return this->Data; }
  /** Set the bits of the effects in the key. With ShadowMethod::Automatic, the number of pixels
   * decides where shadows are sampled. */
  void setBits(VariantKey& key, double pixels) const;

  /** Runs of the stages: none runs unless it is needed. */
  const StageRecord& gradientsRecord() const { return this->Gradients.record(); }
  const StageRecord& startsRecord() const { return this->Starts.record(); }
  const StageRecord& gradientOpacityRecord() const { return this->GradientOpacity.record(); }
  const StageRecord& opaqueShadowsRecord() const { return this->OpaqueShadows.record(); }
  /** Data of another version must be uploaded again. */
  const Fingerprint& gradientsVersion() const { return this->Gradients.input(); }
  const Fingerprint& gradientOpacityVersion() const { return this->GradientOpacity.input(); }
  const Fingerprint& startsVersion() const { return this->Starts.input(); }
  /** Changes only if the shadow of some vertex has changed. */
  Fingerprint opaqueShadowsVersion() const;

private:
  Lighting lighting(vtkRenderer* renderer, vtkVolumeProperty* property) const;
  void updateGradients(const EffectInput& input, bool needed, bool ofCells);
  void updateGradientOpacity(vtkVolume* volume, const EffectInput& input, bool needed);
  void updateStarts(const EffectSource& source, bool needed);
  void updateOpaqueShadows(vtkRenderer* renderer, vtkVolume* volume, const EffectInput& input);
  bool certainlySamplesShadows() const;
  bool samplesShadows(double pixels) const;

  EffectOptions Options;
  EffectData Data;
  double SteepestGradient = 0; // in the normalised frame
  CachedStage Gradients;
  CachedStage GradientOpacity;
  CachedStage Starts;
  CachedStage OpaqueShadows;
  std::uintptr_t DistinctOpaqueShadows = 0;
};

} // namespace tetmarch

#endif
