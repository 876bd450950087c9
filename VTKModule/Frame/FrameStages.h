// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The stages of a frame from geometry to clipping, which need no GL, with what each made last: each
// runs again only when its own input changed.
#ifndef TetMarchFrameFrameStages_h
#define TetMarchFrameFrameStages_h

#include "Appearance/TransferTables.h"
#include "Caching/StageResult.h"
#include "Caching/Switch.h"
#include "Frame/FrameInput.h"
#include "Light/EffectStage.h"
#include "View/View.h"

namespace tetmarch
{

class FrameStages
{
public:
  /** The volume lives longer than the stages. */
  explicit FrameStages(MarchedVolume& volume)
    : Marched(volume)
  {
  }

  /** Limits of the next frames; none at first. */
  void setLimits(const ResourceLimits& limits) { this->Limits = limits; }
  /** These processes have pieces of the volume: see EffectInput. They keep gradients together until
   * others are named, also in frames that one process draws. */
  void setGroup(Group* group, std::uintptr_t generation);

  /** All stages. */
  StageResult update(const FrameInput& input, const Progress& progress);

  // The same in three parts, in this order, for processes that agree between them. Each takes the
  // same input but for what they have agreed on.

  StageResult updateGeometry(const FrameInput& input, const Progress& progress);
  /** Check the array, and choose its drawn components. */
  static StageResult chooseScalars(const FrameInput& input, DrawnScalars& drawn);
  /** The scalars, and how they are shown. */
  StageResult updateScalars(const FrameInput& input, const DrawnScalars& drawn);
  /** Light, view and cuts. */
  StageResult updateRays(const FrameInput& input);

  /** What rays need to find where they enter without lists of entries. Returns an empty string, or
   * what is wrong. */
  std::string prepareEntrySearch();
  /** Until the next update rays begin before the volume, also if the eye is in it. */
  void beginBeforeVolume();

  // What the last update has made.

  const MarchedVolume& volume() const { return this->Marched; }
  ComponentMix mix() const { return this->Mix; }
  const Blending& blending() const { return this->Blend; }
  const TransferTables& tables() const { return this->Tables; }
  const EffectStage& effects() const { return this->Effects; }
  const View& camera() const { return this->Camera; }
  const Clipping& cuts() const { return this->Cut; }
  const RaySamples& samples() const { return this->Samples; }
  /** How far the volume is from the curved cells that it is drawn for: in the normalised frame, and
   * of stored scalars. */
  CurvedDeparture departure() const;
  /** There are scalars that are not finite, and they are shown. */
  bool showsNan() const { return this->NanShown; }
  /** What tables are made of, beside the functions. */
  TableInput tableInput() const;
  /** The level with the trials that the volume needs. */
  AccuracyLevel levelFor(AccuracyLevel level) const;
  /** Why the volume can't be sampled at even distances, and what to do; empty: it can. */
  std::string describeBadSamples() const;
  /** Set the bits of the key that the stages decide, for a picture of this number of pixels. */
  void setBits(VariantKey& key, double pixels) const;

  /** Equal if the same is shown, apart from camera, cuts and accuracy. */
  const Fingerprint& contentVersion() const { return this->Content; }
  /** Of the light at vertices by a variant. The first word is that of the geometry. */
  Fingerprint lightVersion(const VariantKey& key) const;
  /** How often any of the stages has run. */
  std::int64_t runs() const;

private:
  std::string updateBlending(const FrameInput& input);
  StageResult updateTables(const FrameInput& input);
  std::string updateVisibility();
  std::string updateEffects(const FrameInput& input);
  std::string effectsOfComponents(bool showsPicture) const;
  std::string updateView(const FrameInput& input);
  std::string updateEye();
  StageResult updateClipping(const FrameInput& input);

  MarchedVolume& Marched;
  ResourceLimits Limits;
  Group* Processes = nullptr;
  std::uintptr_t Generation = 0;
  ComponentMix Mix = ComponentMix::Single;
  Blending Blend;
  OpacityLaw Law = OpacityLaw::Unstructured;
  TransferTables Tables;
  bool NanShown = false;
  CurvedDeparture Departure; // as given
  Fingerprint VisibilityInput;
  Switch SkipsTransparentCells; // a separate loop passes cells without extinction
  Fingerprint Content;
  EffectStage Effects;
  View Camera;
  Clipping Cut;
  RaySamples Samples;
};

} // namespace tetmarch

#endif
