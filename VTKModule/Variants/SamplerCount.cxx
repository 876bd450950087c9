// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Variants/SamplerCount.h"

#include "Variants/VariantKey.h"

namespace tetmarch
{
namespace
{

// Shaders/tet/..._buffers.glsl
int samplersOfMesh(const VariantKey& key)
{
  const int stored = key.Curvilinear ? 0 : 1;
  const int ofCells = stored + (key.PointScalars ? 0 : 1) + (key.CornerScalars ? 1 : 0);
  const int extra = key.hasComponents() ? 1 : 0;
  const int split = key.SplitCells ? ofCells + (key.PointScalars ? 0 : extra) : 0;
  return ofCells + extra + split + 2 + (key.Hierarchy ? 2 - stored : 0) +
         (key.HiddenCells ? 1 : 0) + (key.EntryLists ? 2 : 0) + (key.VisiblePart ? 3 : 0);
}

// Shaders/structured/..._buffers.glsl
int samplersOfLattice(const VariantKey& key)
{
  const int ofComponents = key.Components == ComponentGroup::ColorAndOpacity ? 2 : 4;
  const int ofValues = key.Slabs ? (key.ManySlabs ? 8 : 2) : key.hasComponents() ? ofComponents : 1;
  return ofValues + (key.Rectilinear ? 1 : 0) + (key.Octree ? 1 : 0) + (key.Leaps ? 1 : 0) +
         (key.HiddenCells ? 1 : 0);
}

// Shaders/light/..._buffers.glsl
int samplersOfLight(const VariantKey& key)
{
  const bool stored = key.hasStoredGradients();
  return (stored ? 1 : 0) + (stored && key.CellGradients && key.SplitCells ? 1 : 0) +
         (key.GradientOpacity ? 1 : 0) + (key.hasVertexLight() ? 1 : 0) +
         (key.samplesSurfaces() ? 1 : 0);
}

} // namespace

int samplersOf(const VariantKey& key)
{
  return (key.Structured ? samplersOfLattice(key) : samplersOfMesh(key)) + samplersOfLight(key) +
         (key.usesTables() ? 2 : 0) + (key.needsVariations() ? 1 : 0) + (key.OpaqueDepth ? 1 : 0) +
         (key.SampledShadows || key.PointSampled ? 1 : 0) + (key.Peeled ? SamplersOfPeeling : 0);
}

VariantKey fittedTo(int units, const VariantKey& key)
{
  if (samplersOf(key) <= units)
  {
    return key;
  }
  VariantKey fewer = key;
  fewer.VisiblePart = false;
  fewer.Leaps = false;
  // Rays of pixels can search the hierarchy that rays towards the light search.
  fewer.EntryLists =
    fewer.EntryLists && (!fewer.Hierarchy || samplersOf(fewer.filtered()) <= units);
  return fewer.filtered();
}

} // namespace tetmarch
