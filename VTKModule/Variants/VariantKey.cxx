// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Variants/VariantKey.h"

#include <algorithm>

namespace tetmarch
{

const std::array<VariantKey::Bit, VariantKey::NumberOfBits>& VariantKey::bits()
{
  static const std::array<Bit, NumberOfBits> rows{ {
    { "POINT_SCALARS", &VariantKey::PointScalars },
    { "RASTER_ENTRY", &VariantKey::RasterEntry },
    { "BVH", &VariantKey::Hierarchy },
    { "OPAQUE_DEPTH", &VariantKey::OpaqueDepth },
    { "HAS_FMA", &VariantKey::HasFma },
    { "ADAPTIVE", &VariantKey::Adaptive },
    { "DIAGNOSTICS", &VariantKey::Diagnostics },
    { "PEELED", &VariantKey::Peeled },
    { "TRANSPARENT_RANGES", &VariantKey::TransparentRanges },
    { "CONSTANT_COLOR", &VariantKey::ConstantColor },
    { "CLIPPED", &VariantKey::Clipped },
    { "CROPPED", &VariantKey::Cropped },
    { "NAN_SHOWN", &VariantKey::NanShown },
    { "HIDDEN_CELLS", &VariantKey::HiddenCells },
    { "EXTREME", &VariantKey::Extreme },
    { "SUM", &VariantKey::Sum },
    { "ISOSURFACES", &VariantKey::Isosurfaces },
    { "INDEPENDENT", &VariantKey::Independent },
    { "COLOR_AND_OPACITY", &VariantKey::ColorAndOpacity },
    { "DIRECT_COLOR", &VariantKey::DirectColor },
    { "CELL_GRADIENTS", &VariantKey::CellGradients },
    { "GRADIENT_OPACITY", &VariantKey::GradientOpacity },
    { "SHADING", &VariantKey::Shading },
    { "HEADLIGHT_ONLY", &VariantKey::HeadlightOnly },
    { "SINGLE_LIGHT", &VariantKey::SingleLight },
    { "WORLD_LIGHTS", &VariantKey::WorldLights },
    { "SCATTERING", &VariantKey::Scattering },
    { "CAST_SHADOWS", &VariantKey::CastShadows },
    { "SEVERAL_SHADOWS", &VariantKey::SeveralShadows },
    { "SAMPLED_SHADOWS", &VariantKey::SampledShadows },
    { "OPAQUE_SHADOWS", &VariantKey::OpaqueShadows },
    { "HEADLIGHT_SHADOWS", &VariantKey::HeadlightShadows },
    { "OCCLUSION", &VariantKey::Occlusion },
    { "SHOW_ILLUMINATION", &VariantKey::ShowIllumination },
    { "SHOW_GRADIENTS", &VariantKey::ShowGradients },
  } };
  return rows;
}

bool VariantKey::operator==(const VariantKey& other) const
{
  return std::all_of(bits().begin(), bits().end(),
    [&](const Bit& bit) { return this->*bit.Member == other.*bit.Member; });
}

VariantKey VariantKey::filtered() const
{
  VariantKey key = *this;
  key.Hierarchy = key.Hierarchy || !key.RasterEntry;
  // Who asks for parts knows where opaque geometry ends them, and takes no counters.
  key.OpaqueDepth = key.OpaqueDepth && !key.Peeled;
  key.Diagnostics = key.Diagnostics && !key.Peeled;
  key.Clipped = key.Clipped || key.Cropped;
  key.dropWhatIsNotBlended();
  key.dropWhatComponentsLack();
  key.ShowIllumination = key.ShowIllumination && !key.ShowGradients;
  key.ConstantColor = key.ConstantColor && !key.ShowIllumination && !key.ShowGradients;
  key.Adaptive = key.Adaptive && key.PointScalars && !key.ConstantColor;
  // Gradients are shown as they are, in no light.
  key.Shading = key.Shading && !key.ShowGradients;
  key.WorldLights = key.WorldLights && key.Shading;
  key.HeadlightOnly = key.HeadlightOnly && key.Shading && !key.WorldLights;
  key.SingleLight = key.SingleLight && key.Shading && !key.HeadlightOnly;
  key.Scattering = key.Scattering && key.Shading;
  key.CastShadows = key.CastShadows && key.Shading && !key.HeadlightOnly;
  key.SeveralShadows = key.SeveralShadows && key.CastShadows && !key.SingleLight;
  key.SampledShadows = key.SampledShadows && key.CastShadows;
  key.OpaqueShadows = key.OpaqueShadows && key.CastShadows;
  key.HeadlightShadows = key.HeadlightShadows && key.Shading && !key.SingleLight;
  key.Occlusion = key.Occlusion && key.Shading;
  // Inside of its cells, a scalar of cells has none.
  key.CellGradients = key.CellGradients && key.PointScalars && key.hasGradients();
  return key;
}

// What a blend mode has no use for: of surfaces, light on them and gradients are seen, of scalars
// nothing but they.
void VariantKey::dropWhatIsNotBlended()
{
  this->Sum = this->Sum && !this->Extreme;
  this->Isosurfaces = this->Isosurfaces && !this->Extreme && !this->Sum;
  if (!this->isComposite())
  {
    this->Independent = false;
    this->ColorAndOpacity = false;
    this->DirectColor = false;
    this->Adaptive = false;
    this->TransparentRanges = false;
    this->NanShown = false;
    this->ConstantColor = false;
    this->GradientOpacity = false;
    this->Scattering = false;
    this->CastShadows = false;
    this->HeadlightShadows = false;
    this->Occlusion = false;
  }
  if (this->Extreme || this->Sum)
  {
    this->Shading = false;
    this->ShowIllumination = false;
    this->ShowGradients = false;
  }
}

// Independent scalars have a gradient each, of which none is the volume's; the colours of several
// are where the table of one doesn't tell.
void VariantKey::dropWhatComponentsLack()
{
  this->ColorAndOpacity = this->ColorAndOpacity && !this->Independent;
  this->DirectColor = this->DirectColor && !this->Independent && !this->ColorAndOpacity;
  this->ConstantColor = this->ConstantColor && !this->hasComponents();
  if (this->Independent)
  {
    this->TransparentRanges = false;
    this->GradientOpacity = false;
    this->Shading = false;
    this->ShowIllumination = false;
    this->ShowGradients = false;
  }
}

VariantKey VariantKey::ofVertexLight() const
{
  VariantKey key;
  key.PointScalars = this->PointScalars;
  key.Hierarchy = this->Hierarchy;
  key.HasFma = this->HasFma;
  key.Adaptive = false;
  key.NanShown = this->NanShown;
  key.HiddenCells = this->HiddenCells;
  key.GradientOpacity = this->GradientOpacity;
  key.CellGradients = this->CellGradients;
  key = key.filtered();
  key.OpaqueShadows = this->OpaqueShadows;
  return key;
}

VariantKey VariantKey::ofPick() const
{
  VariantKey key = this->ofEntries();
  key.OpaqueDepth = true;
  key.PointScalars = this->PointScalars;
  key.Clipped = this->Clipped;
  key.Cropped = this->Cropped;
  key.NanShown = this->NanShown;
  key.HiddenCells = this->HiddenCells;
  key.Extreme = this->Extreme;
  key.Sum = this->Sum;
  key.Isosurfaces = this->Isosurfaces;
  key.Independent = this->Independent; // of dependent ones the scalar is that of the opacity
  key.GradientOpacity = this->GradientOpacity;
  key.CellGradients = this->CellGradients;
  return key.filtered();
}

VariantKey VariantKey::ofEntries() const
{
  VariantKey key;
  key.RasterEntry = this->RasterEntry;
  key.Hierarchy = this->Hierarchy;
  key.OpaqueDepth = this->OpaqueDepth;
  key.HasFma = this->HasFma;
  key.Adaptive = false;
  return key.filtered();
}

std::string VariantKey::defines() const
{
  std::string text;
  const auto define = [&text](const char* name, bool value)
  { text += std::string("#define TETMARCH_") + name + (value ? " 1\n" : " 0\n"); };
  for (const Bit& bit : bits())
  {
    define(bit.Name, this->*bit.Member);
  }
  const bool lit = this->Shading || this->ShowGradients;
  define("COMPOSITE", this->isComposite());
  define("DEPENDENT", this->isDependent());
  define("COMPONENTS", this->hasComponents());
  define("PASSES_CELLS", this->passesCells());
  define("ERROR_BOUND", this->hasErrorBound());
  define("EFFECTS", this->hasGradients());
  define("LIT", lit);
  define("LIGHT_ERROR", lit && this->Diagnostics && this->isComposite());
  define("VERTEX_GRADIENTS", this->hasVertexGradients());
  define("VERTEX_LIGHT", this->hasVertexLight());
  define("SHADOWS", this->hasShadows());
  define("EXACT_LIGHT", false); // the reference has it
  return text;
}

} // namespace tetmarch
