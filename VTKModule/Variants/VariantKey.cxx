// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Variants/VariantKey.h"

#include "Variants/Features.h"

namespace tetmarch
{

const std::array<VariantKey::Feature, VariantKey::NumberOfFeatures>& VariantKey::features()
{
  static_assert(NumberOfFeatures == TETMARCH_NUMBER_OF_KEY_FEATURES, "one for each row");
  static const std::array<Feature, NumberOfFeatures> rows{ {
#include "Variants/FeatureRows.inc"
  } };
  return rows;
}

bool VariantKey::Feature::isOn(const VariantKey& key) const
{
  if (const auto* member = std::get_if<bool VariantKey::*>(&this->Value))
  {
    return key.**member;
  }
  if (const auto* blend = std::get_if<BlendGroup>(&this->Value))
  {
    return key.Blend == *blend;
  }
  return key.Components == std::get<ComponentGroup>(this->Value);
}

void VariantKey::Feature::set(VariantKey& key, bool on) const
{
  if (const auto* member = std::get_if<bool VariantKey::*>(&this->Value))
  {
    key.** member = on;
  }
  else if (on != this->isOn(key))
  {
    if (const auto* blend = std::get_if<BlendGroup>(&this->Value))
    {
      key.Blend = on ? *blend : BlendGroup::Composite;
    }
    else
    {
      key.Components = on ? std::get<ComponentGroup>(this->Value) : ComponentGroup::Single;
    }
  }
}

std::uint64_t VariantKey::bits() const
{
  std::uint64_t bits = 0;
  for (const Feature& feature : features())
  {
    bits |= feature.isOn(*this) ? feature.Bit : 0;
  }
  return bits;
}

bool VariantKey::operator==(const VariantKey& other) const { return this->bits() == other.bits(); }

VariantKey VariantKey::filtered() const
{
  VariantKey key = *this;
  key.dropWhatLatticesLack();
  // Depth peeling ends parts of rays at opaque geometry itself, and reads no counters.
  key.OpaqueDepth = key.OpaqueDepth && !key.Peeled;
  key.Diagnostics = key.Diagnostics && !key.Peeled;
  key.Clipped = key.Clipped || key.Cropped;
  key.dropWhatIsNotBlended();
  key.dropWhatComponentsLack();
  // Each of several scalars has two textures or more.
  key.ManySlabs = key.Slabs && (key.ManySlabs || key.hasComponents());
  key.ShowIllumination = key.ShowIllumination && !key.ShowGradients;
  key.ConstantColor = key.ConstantColor && !key.ShowIllumination && !key.ShowGradients;
  // If the scalar bends, the optical depth has an error even with one colour.
  key.Adaptive = key.Adaptive && key.PointScalars && (!key.ConstantColor || key.Structured);
  // Gradients are shown without light.
  key.Shading = key.Shading && !key.ShowGradients;
  key.WorldLights = key.WorldLights && key.Shading;
  key.HeadlightOnly = key.HeadlightOnly && key.Shading && !key.WorldLights;
  key.SingleLight = key.SingleLight && key.Shading && !key.HeadlightOnly;
  key.FewLights = key.FewLights && key.Shading && !key.HeadlightOnly && !key.SingleLight &&
                  !key.HasFma && !key.Structured;
  key.Scattering = key.Scattering && key.Shading;
  key.CastShadows = key.CastShadows && key.Shading && !key.HeadlightOnly;
  key.SeveralShadows = key.SeveralShadows && key.CastShadows && !key.SingleLight;
  key.LightTolerance = key.LightTolerance && key.Shading && !key.PointSampled;
  key.Occlusion = key.Occlusion && key.Shading;
  key.SampledShadows = (key.SampledShadows && key.CastShadows) ||
                       (key.LightTolerance && (key.CastShadows || key.Occlusion));
  key.CurvedError = key.CurvedError && key.Diagnostics && key.isComposite() && !key.Structured &&
                    !key.Curvilinear && !key.hasComponents();
  // A curved cell may be visible in the place of a transparent one.
  key.VisiblePart = key.VisiblePart && key.EntryLists && !key.CurvedError;
  key.TransparentRanges = key.TransparentRanges && !key.VisiblePart && !key.CurvedError;
  // A surface may lie between two cells. The march must know both, so a run must not end there.
  key.Reentered =
    key.EntryLists && key.Blend != BlendGroup::Isosurfaces && (key.Reentered || key.VisiblePart);
  // Rays of pixels have lists, rays towards the light have none.
  key.Hierarchy = !key.Structured && (!key.EntryLists || (key.Hierarchy && key.SampledShadows));
  key.OpaqueShadows = key.OpaqueShadows && key.CastShadows;
  key.HeadlightShadows = key.HeadlightShadows && key.Shading && !key.SingleLight;
  key.LightThroughCuts = key.LightThroughCuts && key.Clipped && (key.CastShadows || key.Occlusion);
  // A scalar of cells has no gradient inside its cells.
  // Where the scalar jumps at vertices, these have no gradient.
  key.CornerScalars =
    key.CornerScalars && key.PointScalars && !key.Structured && !key.hasComponents();
  // Computed tetrahedra need no buffer, and share their vertices.
  key.SplitCells = key.SplitCells && !key.Curvilinear;
  key.JoinedSides = key.JoinedSides && key.Curvilinear;
  key.CornerScalars = key.CornerScalars && !key.Curvilinear;
  key.CellGradients =
    (key.CellGradients || key.CornerScalars) && key.PointScalars && key.hasGradients();
  // Light that is the same in the whole of a cell is as fine as it gets.
  key.LightTolerance = key.LightTolerance && (key.SampledShadows || key.hasLitParts());
  return key;
}

// A ray enters a lattice once, through its outermost planes. Only lattices without leaves are
// sampled.
void VariantKey::dropWhatLatticesLack()
{
  if (this->Structured)
  {
    this->EntryLists = false;
    this->Hierarchy = false;
    this->HasFma = false;
    this->SplitCells = false;
    this->Curvilinear = false;
    this->JoinedSides = false;
  }
  this->Rectilinear = this->Rectilinear && this->Structured;
  this->Octree = this->Octree && this->Structured && !this->PointScalars;
  // As many values as leaves can have numbers fit into a texture.
  this->Slabs = this->Slabs && this->Structured && !this->Octree;
  // Extremes and sums need all cells on a ray. Surfaces between constant cells are in no cell.
  this->Leaps = this->Leaps && this->Structured && !this->Octree && !this->isKnownAtEnd() &&
                (this->isComposite() || this->PointScalars);
  // Volumes that are mostly transparent have transparent blocks.
  this->TransparentRanges = this->TransparentRanges && (this->Leaps || !this->Structured);
  // Other blend modes are exact at each level, and samples have one scalar.
  this->PointSampled = this->PointSampled && this->Structured && !this->Octree &&
                       this->isComposite() && this->Components == ComponentGroup::Single;
  this->Adaptive = this->Adaptive && !this->PointSampled;
}

// Isosurfaces have light and gradients; the other modes only scalars.
void VariantKey::dropWhatIsNotBlended()
{
  if (!this->isComposite())
  {
    this->Components = ComponentGroup::Single;
    this->Adaptive = false;
    this->TransparentRanges = false;
    this->NanShown = false;
    this->ConstantColor = false;
    this->GradientOpacity = false;
    this->LightTolerance = false;
    this->Scattering = false;
    this->CastShadows = false;
    this->HeadlightShadows = false;
    this->Occlusion = false;
  }
  if (this->isKnownAtEnd())
  {
    this->Shading = false;
    this->ShowIllumination = false;
    this->ShowGradients = false;
  }
}

// Independent scalars have a gradient each, and the volume none. With several tables, that of the
// opacity does not determine whether everything visible has one colour.
void VariantKey::dropWhatComponentsLack()
{
  this->ConstantColor = this->ConstantColor && !this->hasComponents();
  if (this->Components == ComponentGroup::Independent)
  {
    this->TransparentRanges = false;
    this->GradientOpacity = false;
    this->LightTolerance = false;
    this->Scattering = false;
    this->CastShadows = false;
    this->HeadlightShadows = false;
    this->Occlusion = false;
    this->ShowIllumination = false;
    this->ShowGradients = false;
  }
}

VariantKey VariantKey::ofVertexLight(bool reenters) const
{
  VariantKey key;
  key.Structured = this->Structured;
  key.Rectilinear = this->Rectilinear;
  key.Octree = this->Octree;
  key.Slabs = this->Slabs;
  key.ManySlabs = this->ManySlabs;
  key.Leaps = this->Leaps;
  key.SplitCells = this->SplitCells;
  key.Curvilinear = this->Curvilinear;
  key.JoinedSides = this->JoinedSides;
  key.CornerScalars = this->CornerScalars;
  key.PointScalars = this->PointScalars;
  key.HasFma = this->HasFma;
  key.Adaptive = false;
  key.NanShown = this->NanShown;
  key.HiddenCells = this->HiddenCells;
  key.GradientOpacity = this->GradientOpacity;
  key.CellGradients = this->CellGradients;
  key = key.filtered();
  key.EntryLists = false;
  key.Hierarchy = reenters && !key.Structured;
  key.OpaqueShadows = this->OpaqueShadows && !this->SampledShadows;
  key.LightThroughCuts = this->LightThroughCuts;
  return key;
}

VariantKey VariantKey::ofPick() const
{
  VariantKey key = this->ofEntries();
  key.OpaqueDepth = true;
  key.Octree = this->Octree;
  key.Leaps = this->Leaps;
  // Else there would be more samplers than a GL need have.
  key.VisiblePart = this->VisiblePart && !(this->SplitCells && this->CornerScalars);
  key.SplitCells = this->SplitCells;
  key.Curvilinear = this->Curvilinear;
  key.JoinedSides = this->JoinedSides;
  key.CornerScalars = this->CornerScalars;
  key.PointScalars = this->PointScalars;
  // If the scalar is linear, the optical depth of a segment is exact.
  key.Adaptive = this->Structured;
  key.Clipped = this->Clipped;
  key.Cropped = this->Cropped;
  key.NanShown = this->NanShown;
  key.HiddenCells = this->HiddenCells;
  key.Blend = this->Blend;
  // Dependent components are picked by the scalar of the opacity.
  key.Components =
    this->Components == ComponentGroup::Independent ? this->Components : ComponentGroup::Single;
  key.GradientOpacity = this->GradientOpacity;
  key.CellGradients = this->CellGradients;
  return key.filtered();
}

VariantKey VariantKey::ofEntries() const
{
  VariantKey key;
  key.EntryLists = this->EntryLists;
  key.Hierarchy = this->Hierarchy;
  key.OpaqueDepth = this->OpaqueDepth;
  key.HasFma = this->HasFma;
  key.Structured = this->Structured;
  key.Rectilinear = this->Rectilinear;
  key.Slabs = this->Slabs;
  key.ManySlabs = this->ManySlabs;
  key.Adaptive = false;
  return key.filtered();
}

std::string VariantKey::defines() const
{
  std::string text;
  const auto define = [&text](const char* name, bool value)
  { text += std::string("#define TETMARCH_") + name + (value ? " 1\n" : " 0\n"); };
  for (const Feature& feature : features())
  {
    define(feature.Name, feature.isOn(*this));
  }
  // Defaults, unless the driver or a file defines them after these lines.
  for (const char* name : {
#include "Variants/KeylessFeatures.inc"
       })
  {
    define(name, false);
  }
  return text;
}

} // namespace tetmarch
