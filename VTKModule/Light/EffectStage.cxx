// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Light/EffectStage.h"

#include "Caching/WithinMemory.h"
#include "Light/LightPreset.h"
#include "Processes/Group.h"

#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyData.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetmarch
{
namespace
{

double steepest(const std::vector<std::array<float, 3>>& gradients)
{
  double most = 0;
  for (const std::array<float, 3>& g : gradients)
  {
    most = std::max(most, std::hypot(double(g[0]), double(g[1]), double(g[2])));
  }
  return most;
}

// The steepest gradient of the whole volume, given that of this piece.
double steepestOfAll(double own, Group* processes)
{
  std::vector<float> least{ static_cast<float>(-own) };
  if (processes)
  {
    processes->keepLeast(least);
    return -double(least.front());
  }
  return own;
}

// The getter of a missing function would create one.
bool mayHaveGradientOpacity(vtkVolumeProperty* property)
{
  return !property->GetDisableGradientOpacity() &&
         property->GetTransferFunctionMode() == vtkVolumeProperty::TF_1D &&
         property->HasGradientOpacity();
}

// The input of shadows of opaque geometry: its data and positions, and the lights.
Fingerprint inputOf(const std::vector<OpaqueSurface>& surfaces, vtkVolume* volume,
  const LightUniforms& lights, const Fingerprint& geometry)
{
  Fingerprint input = geometry;
  for (const OpaqueSurface& surface : surfaces)
  {
    add(input, surface.Data);
    addAll(input, surface.ToWorld);
  }
  std::array<double, 16> matrix{};
  vtkMatrix4x4::DeepCopy(matrix.data(), volume->GetMatrix());
  addAll(input, matrix);
  for (const auto& source : lights.ShadowSources)
  {
    addAll(input, source);
  }
  add(input, lights.OpaqueReach);
  return input;
}

// Vertices are those of a mesh, or nodes of an image that are four cells apart.
int turnsOfSample(const LightUniforms& lights, std::size_t vertices, bool ofMesh)
{
  const double turnsOfRay = (ofMesh ? 1.4 : 8.0) * std::cbrt(static_cast<double>(vertices));
  const double rays = static_cast<double>(lights.ShadowSources.size()) +
                      lights.OcclusionDirections * 1.5 * lights.OcclusionRadius;
  return static_cast<int>(std::max(rays * turnsOfRay, 1.0));
}

bool isShaded(vtkVolumeProperty* property, const EffectOptions& options)
{
  return options.showsSurfaces() &&
         (options.Preset != LightPreset::OfScene || property->GetShade());
}

} // namespace

EffectOptions usedOptions(const EffectOptions& options)
{
  EffectOptions used = withPreset(options);
  if (options.Blend != BlendMode::Composite)
  {
    used.Shadows = ShadowMethod::Off;
    used.Scattering = 0;
    used.Occlusion = false;
    used.OpaqueShadows = false;
  }
  if (!used.showsSurfaces())
  {
    used.Shown = Subject::Picture;
  }
  return used;
}

bool mayHaveGradients(vtkVolumeProperty* property, const EffectOptions& options)
{
  const EffectOptions used = usedOptions(options);
  return isShaded(property, used) || used.Shown != Subject::Picture ||
         (used.Blend == BlendMode::Composite && mayHaveGradientOpacity(property));
}

std::string EffectStage::update(
  vtkRenderer* renderer, vtkVolume* volume, const EffectOptions& options, const EffectInput& input)
{
  vtkVolumeProperty* property = volume->GetProperty();
  this->Options = usedOptions(options);
  const std::string shortage = withinMemory("the effects of light",
    [&]
    {
      this->Data.Lights = makeLightUniforms(
        this->lighting(renderer, property), this->Options, volume, input.Source->frame());
      const bool byGradient =
        this->Options.Blend == BlendMode::Composite && mayHaveGradientOpacity(property);
      const bool needed = byGradient || !this->Data.Lights.Sources.empty() ||
                          this->Options.Shown == Subject::Gradients;
      this->updateGradients(input, needed,
        input.Source->needsCellGradients() ||
          (options.CellGradients && input.Source->hasCellGradients()));
      this->updateGradientOpacity(volume, input, byGradient);
      this->updateStarts(*input.Source, this->Data.Lights.hasVolumeLight());
      this->Data.Lights.TurnsOfSample = turnsOfSample(
        this->Data.Lights, this->Data.VertexStarts.size(), input.Source->storesGradients());
      this->updateOpaqueShadows(renderer, volume, input);
    });
  if (!shortage.empty())
  {
    this->clear();
  }
  return shortage;
}

Lighting EffectStage::lighting(vtkRenderer* renderer, vtkVolumeProperty* property) const
{
  if (!isShaded(property, this->Options))
  {
    return {};
  }
  return this->Options.Preset == LightPreset::OfScene
           ? lightingOf(renderer, property)
           : presetLighting(this->Options.Preset, renderer);
}

void EffectStage::clear()
{
  this->Data = {};
  for (CachedStage* made :
    { &this->Gradients, &this->GradientOpacity, &this->Starts, &this->OpaqueShadows })
  {
    made->clear();
  }
}

void EffectStage::updateGradients(const EffectInput& input, bool needed, bool ofCells)
{
  Fingerprint which;
  if (needed)
  {
    which = input.Source->scalarsVersion();
    which.push_back(input.Generation);
    which.push_back(input.OfComponents ? 2 : (ofCells ? 1 : 0));
  }
  this->Gradients.update(
    which, [this] { std::vector<std::array<float, 3>>().swap(this->Data.Gradients); },
    [&]
    {
      this->Data.CellGradients = ofCells && !input.OfComponents;
      this->Data.Gradients = input.OfComponents ? input.Source->componentGradients(input.Processes)
                                                : input.Source->gradients(ofCells, input.Processes);
      this->SteepestGradient = input.Source->storesGradients()
                                 ? steepestOfAll(steepest(this->Data.Gradients), input.Processes)
                                 : std::numeric_limits<double>::infinity();
    });
}

void EffectStage::updateGradientOpacity(vtkVolume* volume, const EffectInput& input, bool needed)
{
  Fingerprint which;
  if (needed)
  {
    which = this->Gradients.input();
    add(which, volume->GetProperty()->GetGradientOpacity());
  }
  this->GradientOpacity.update(
    which, [this] { this->Data.GradientOpacity = {}; },
    [&]
    {
      // From gradients of the stored scalar in the normalised frame to those of the data.
      const double unit = input.Source->range().width() / input.Source->frame().Radius;
      this->Data.GradientOpacity =
        gradientOpacityOf(volume->GetProperty(), this->SteepestGradient * unit);
      this->Data.GradientOpacityScale = unit / this->Data.GradientOpacity.Unit;
    });
}

void EffectStage::refreshStarts(const EffectSource& source)
{
  this->updateStarts(source, !this->Starts.input().empty());
}

void EffectStage::updateStarts(const EffectSource& source, bool needed)
{
  Fingerprint which;
  if (needed)
  {
    which = source.startsVersion();
  }
  this->Starts.update(
    which, [this] { std::vector<EffectSource::VertexStart>().swap(this->Data.VertexStarts); },
    [&] { this->Data.VertexStarts = source.vertexStarts(); });
}

void EffectStage::updateOpaqueShadows(
  vtkRenderer* renderer, vtkVolume* volume, const EffectInput& input)
{
  const LightUniforms& lights = this->Data.Lights;
  std::vector<OpaqueSurface> surfaces;
  if (this->Options.OpaqueShadows && !lights.ShadowSources.empty())
  {
    surfaces = opaqueSurfaces(renderer, input.Blocks);
  }
  const bool atVertices = !this->certainlySamplesShadows();
  Fingerprint which;
  if (!surfaces.empty())
  {
    which = inputOf(surfaces, volume, lights, input.Source->geometryVersion());
    which.push_back(atVertices ? 1 : 0);
  }
  std::vector<std::uint8_t> shadowedBefore;
  const auto free = [&]
  {
    shadowedBefore.swap(this->Data.ShadowedVertices);
    if (which.empty())
    {
      this->Data.Opaque = {};
    }
  };
  const auto make = [&]
  {
    this->Data.Opaque.update(surfaces, volume, input.Source->frame(), lights);
    const std::vector<EffectSource::VertexStart>& starts = this->Data.VertexStarts;
    if (atVertices && this->Data.Opaque.size() > 0)
    {
      this->Data.ShadowedVertices =
        this->Data.Opaque.ofPoints(starts.size(), [&](std::size_t vertex, Vector3& point)
          { return input.Source->startPoint(vertex, starts[vertex], point); });
    }
    this->DistinctOpaqueShadows += this->Data.ShadowedVertices == shadowedBefore ? 0 : 1;
  };
  this->OpaqueShadows.update(which, free, make);
}

Fingerprint EffectStage::opaqueShadowsVersion() const
{
  return this->Data.ShadowedVertices.empty() ? Fingerprint{ 0 }
                                             : Fingerprint{ this->DistinctOpaqueShadows };
}

bool EffectStage::certainlySamplesShadows() const
{
  return this->Options.Shadows == ShadowMethod::AlongRays || this->Options.Tolerance > 0;
}

bool EffectStage::samplesShadows(double pixels) const
{
  // A ray of the picture takes about 8 samples of each light, a vertex one. A tolerance takes more,
  // but where they matter.
  constexpr double samples = 8;
  // Scattered light casts shadows even if the method is off; the cheaper method is used.
  return this->certainlySamplesShadows() ||
         (this->Options.Shadows != ShadowMethod::AtVertices &&
           static_cast<double>(this->Data.VertexStarts.size()) > samples * pixels);
}

void EffectStage::setBits(VariantKey& key, double pixels) const
{
  const LightUniforms& lights = this->Data.Lights;
  key.CellGradients = this->Data.CellGradients;
  key.GradientOpacity = !this->Data.GradientOpacity.empty();
  key.Shading = !lights.Sources.empty();
  key.HeadlightOnly = lights.isHeadlightOnly();
  key.SingleLight = lights.Sources.size() == 1 && !lights.Sources[0].Headlight;
  key.FewLights = lights.Sources.size() <= LightUniforms::FewLights;
  key.WorldLights = lights.InWorld;
  key.Scattering = lights.ScatteringBlending > 0;
  key.CastShadows = !lights.ShadowSources.empty();
  key.SeveralShadows = lights.ShadowSources.size() > 1;
  key.SampledShadows = this->samplesShadows(pixels);
  key.LightTolerance = this->Options.Tolerance > 0;
  key.LightThroughCuts = this->Options.ThroughCuts;
  key.OpaqueShadows = this->Data.Opaque.size() > 0;
  key.HeadlightShadows = lights.hasHeadlightShadows();
  key.Occlusion = lights.OcclusionDirections > 0;
  key.ShowIllumination = this->Options.Shown == Subject::Illumination;
  key.ShowGradients = this->Options.Shown == Subject::Gradients;
}

} // namespace tetmarch
