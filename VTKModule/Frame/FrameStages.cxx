// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/FrameStages.h"

#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace tetmarch
{
namespace
{

// From this transparent share on, a separate loop for cells in which nothing is seen is worth its
// cost: rays in lockstep wait for each other at its end. Down to the other share it costs little.
constexpr double LeastShareToSkip = 0.5;
constexpr double LeastShareToKeepSkipping = 0.25;

} // namespace

void FrameStages::setGroup(Group* group, std::uintptr_t generation)
{
  this->Processes = group;
  this->Generation = generation;
}

StageResult FrameStages::update(const FrameInput& input, const Progress& progress)
{
  DrawnScalars drawn;
  return this->updateGeometry(input, progress)
    .then([&] { return chooseScalars(input, drawn); })
    .then([&] { return this->updateScalars(input, drawn); })
    .then([&] { return this->updateRays(input); });
}

StageResult FrameStages::updateGeometry(const FrameInput& input, const Progress& progress)
{
  const std::string error =
    this->Marched.updateGeometry(input.Drawn.Volume, this->Limits, progress);
  return error.empty() ? stoppedUnless(!this->Marched.isEmpty()) : StageResult{ error };
}

StageResult FrameStages::chooseScalars(const FrameInput& input, DrawnScalars& drawn)
{
  const DrawnData& from = input.Drawn;
  drawn.Whole = from.Whole;
  return { tetmarch::chooseScalars(from.Volume.Data, from.Scalars.Array, from.Scalars.OfCells,
    from.Vector, input.Volume->GetProperty(), drawn) };
}

StageResult FrameStages::updateScalars(const FrameInput& input, const DrawnScalars& drawn)
{
  this->Mix = drawn.Mix;
  this->Law = input.Law;
  this->Departure = input.Drawn.Departure;
  VolumeInput volume = input.Drawn.Volume;
  // Gradients at vertices are found by all processes or by none.
  volume.TakesCorners =
    !this->Processes || !mayHaveGradients(input.Volume->GetProperty(), input.Effects);
  std::string error = this->Marched.updateScalars(volume, drawn);
  error = error.empty() ? this->updateBlending(input) : error;
  return error.empty() ? this->updateTables(input) : StageResult{ error };
}

std::string FrameStages::updateBlending(const FrameInput& input)
{
  const std::string error = makeBlending(
    input.Drawn.Blend, input.Volume->GetProperty(), this->Marched.range(), this->Blend);
  return error.empty() && this->Mix != ComponentMix::Single && !this->Blend.isComposite()
           ? "Several components are drawn together by composite blending alone, but the blend "
             "mode is another. Choose one of them by VectorMode."
           : error;
}

// Where the scalar bends, a segment crosses narrow peaks by more subsegments until the tolerance is
// kept: of volumes with peaks of a hundredth of the range, up to 200 in a cell at 1/255.
AccuracyLevel FrameStages::levelFor(AccuracyLevel level) const
{
  constexpr int Bent = 8;
  level.MostTrials *= level.Adaptive && this->Marched.isStructured() ? Bent : 1;
  return level;
}

TableInput FrameStages::tableInput() const
{
  return { this->Law, &this->Blend, this->Mix, this->Marched.range(), this->Marched.extraRanges(),
    this->Marched.isStructured() || isAny(this->Departure), this->Limits.TexelsPerBuffer };
}

CurvedDeparture FrameStages::departure() const
{
  return { this->Departure.Distance / this->Marched.frame().Radius,
    this->Departure.Value / this->Marched.range().width() };
}

StageResult FrameStages::updateTables(const FrameInput& input)
{
  vtkVolumeProperty* property = input.Volume->GetProperty();
  std::string error = this->Tables.update(property, this->tableInput(), input.Level);
  if (!error.empty())
  {
    return { error };
  }
  const IntegralTable& table = this->Tables.first();
  this->NanShown = input.DrawNan && !this->Marched.range().AllFinite && table.NanColor[3] > 0;
  error = this->updateVisibility();
  if (!error.empty())
  {
    return { error };
  }
  this->Content = this->Tables.shown();
  add(this->Content, this->Marched.version());
  add(this->Content, property->GetScalarOpacityUnitDistance());
  this->Content.push_back(input.DrawNan ? 1 : 0);
  add(this->Content, versionOf(this->Blend));
  // Sums are shown even where they are 0.
  return stoppedUnless(this->Tables.isVisible() || this->NanShown || this->Blend.isSum());
}

std::string FrameStages::updateVisibility()
{
  Fingerprint input = this->Marched.version();
  input.push_back(static_cast<std::uintptr_t>(this->Tables.record().Runs));
  input.push_back(this->NanShown ? 1 : 0);
  add(input, versionOf(this->Blend));
  if (input == this->VisibilityInput)
  {
    return {};
  }
  this->VisibilityInput.clear();
  std::string error = this->Marched.updateVisibility(
    this->Tables.first(), this->Tables.components(), this->Blend, this->NanShown);
  if (error.empty())
  {
    const double share = this->Marched.transparentShare(this->Tables.first());
    this->SkipsTransparentCells.update(
      share >= LeastShareToSkip, share >= LeastShareToKeepSkipping, this->Marched.version());
    this->VisibilityInput = input;
  }
  return error;
}

StageResult FrameStages::updateRays(const FrameInput& input)
{
  this->Samples = input.Drawn.Samples;
  std::string error = this->updateEffects(input);
  error = error.empty() ? this->updateView(input) : error;
  return error.empty() ? this->updateClipping(input) : StageResult{ error };
}

std::string FrameStages::updateEffects(const FrameInput& input)
{
  const EffectInput from{ &this->Marched, input.Blocks, this->Processes, this->Generation,
    this->Mix == ComponentMix::Independent };
  std::string error = this->Effects.update(input.Renderer, input.Volume, input.Effects, from);
  if (error.empty() && this->Mix == ComponentMix::Independent)
  {
    error = this->effectsOfComponents(input.Effects.Shown == Subject::Picture);
    if (!error.empty())
    {
      this->Effects.clear();
    }
  }
  return error;
}

// Independent components have surfaces that are lit, and no other effect.
std::string FrameStages::effectsOfComponents(bool showsPicture) const
{
  const EffectData& effects = this->Effects.data();
  if (showsPicture && effects.empty())
  {
    return {};
  }
  const LightUniforms& lights = effects.Lights;
  if (showsPicture && effects.GradientOpacity.empty() && !lights.hasVolumeLight() &&
      !lights.hasHeadlightShadows() && !(lights.ScatteringBlending > 0))
  {
    return {};
  }
  return "Several independent components are lit without shadows, ambient occlusion, scattering "
         "and "
         "gradient opacity, and have no views of gradients and illumination, but one of these is "
         "on. "
         "Switch that off, or choose one component by VectorMode.";
}

std::string FrameStages::updateView(const FrameInput& input)
{
  const double unit = input.Volume->GetProperty()->GetScalarOpacityUnitDistance();
  if (!(unit > 0))
  {
    return "The scalar opacity unit distance is " + std::to_string(unit) +
           "; it must be above 0 (vtkVolumeProperty::SetScalarOpacityUnitDistance).";
  }
  if (!makeView(input.Renderer, input.Volume, this->Marched.frame(), unit, input.Law, this->Camera))
  {
    return "The matrix of the volume or of the camera is singular or not finite.";
  }
  const bool lightReenters =
    this->Marched.mayReenter() && this->Effects.data().Lights.hasVolumeLight();
  std::string error = lightReenters ? this->prepareEntrySearch() : std::string();
  return error.empty() ? this->updateEye() : error;
}

// If rays begin in the volume, their entries are listed or else searched.
std::string FrameStages::updateEye()
{
  VariantKey key;
  this->setBits(key, 1);
  key.EntryLists = !this->Marched.isStructured();
  key.VisiblePart = true;
  const View& camera = this->Camera;
  const bool mayList = camera.CutsNearPlane && camera.Eye[3] != 0 && key.filtered().VisiblePart;
  const Vector3 eye{ { camera.Eye[0], camera.Eye[1], camera.Eye[2] } };
  const std::string error = this->Marched.updateEye(mayList ? &eye : nullptr);
  const bool searches = camera.CutsNearPlane && !this->Marched.startsAtEye();
  return error.empty() && searches ? this->prepareEntrySearch() : error;
}

void FrameStages::beginBeforeVolume() { this->Marched.updateEye(nullptr); }

std::string FrameStages::prepareEntrySearch()
{
  const std::string error = this->Marched.prepareEntrySearch();
  std::string shortage = withinMemory(
    "the starts of rays towards the light", [&] { this->Effects.refreshStarts(this->Marched); });
  return error.empty() ? shortage : error;
}

StageResult FrameStages::updateClipping(const FrameInput& input)
{
  const std::string error =
    makeClipping(input.Drawn.Cuts, input.Volume, this->Marched.frame(), this->Cut);
  return error.empty() ? stoppedUnless(!this->Cut.LeavesNothing) : StageResult{ error };
}

std::string FrameStages::describeBadSamples() const
{
  if (this->Mix != ComponentMix::Single)
  {
    return "The accuracy level is Sampled, which draws one component, but several are drawn "
           "together. Choose one by VectorMode and VectorComponent, or another accuracy level, "
           "such as SetAccuracyLevelToDefault().";
  }
  return this->Marched.takesSamples()
           ? describeBadDistance(this->Samples, this->Marched.frame())
           : "The accuracy level is Sampled, which is for images and rectilinear grids alone. "
             "Choose another one, such as SetAccuracyLevelToDefault().";
}

void FrameStages::setBits(VariantKey& key, double pixels) const
{
  this->Marched.setBits(key);
  key.EntryLists =
    !this->Marched.isStructured() && (!this->Camera.CutsNearPlane || this->Marched.startsAtEye());
  key.TransparentRanges = this->SkipsTransparentCells.isOn();
  key.ConstantColor = this->Tables.first().Traits.ConstantColor;
  key.Clipped = this->Cut.cuts();
  key.Cropped = this->Cut.Cropped;
  key.NanShown = this->NanShown;
  this->Blend.setBits(key);
  this->Tables.components().setBits(key);
  this->Effects.setBits(key, pixels);
}

Fingerprint FrameStages::lightVersion(const VariantKey& key) const
{
  const LightUniforms& lights = this->Effects.data().Lights;
  Fingerprint version = this->Marched.version();
  version.push_back(static_cast<std::uintptr_t>(this->Tables.record().Runs));
  addAll(version, this->Camera.ThicknessMatrix);
  for (const auto& source : lights.ShadowSources)
  {
    addAll(version, source);
  }
  add(version, lights.Reach);
  add(version, lights.OcclusionRadius);
  version.push_back(static_cast<std::uintptr_t>(lights.OcclusionDirections));
  // The pass at vertices leaves out the light that rays of the picture sample.
  version.push_back(key.SampledShadows ? 1 : 0);
  version.push_back(key.samplesOcclusion() ? 1 : 0);
  version.push_back(key.NanShown ? 1 : 0);
  version.push_back(key.LightThroughCuts ? 1 : 0);
  for (std::size_t i = 0; key.LightThroughCuts && i < this->Cut.Planes.size(); ++i)
  {
    addAll(version, this->Cut.Planes[i]);
  }
  add(version, this->Effects.gradientOpacityVersion());
  if (!key.SampledShadows)
  {
    add(version, this->Effects.opaqueShadowsVersion());
  }
  return version;
}

std::int64_t FrameStages::runs() const
{
  return this->Marched.runs() + this->Tables.record().Runs + this->Effects.gradientsRecord().Runs +
         this->Effects.gradientOpacityRecord().Runs + this->Effects.startsRecord().Runs +
         this->Effects.opaqueShadowsRecord().Runs;
}

} // namespace tetmarch
