// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a picture shows of the scalars along a ray.
#ifndef TetMarchAppearanceBlending_h
#define TetMarchAppearanceBlending_h

#include "Caching/Fingerprint.h"
#include "Optics/FittingTable.h"

#include <array>
#include <string>
#include <vector>

class vtkVolumeProperty;

namespace tetmarch
{

struct ScalarRange;
struct VariantKey;

/** As vtkVolumeMapper::BlendModes. */
enum class BlendMode
{
  Composite,
  Maximum,
  Minimum,
  Average,
  Additive,
  IsoSurface
};

/** As the array in Shaders/gather/blend_buffers.glsl. */
constexpr int MostIsoSurfaces = 32;

struct Blending
{
  BlendMode Mode = BlendMode::Composite;
  /** Stored scalars (0..1) that count: all, but for averages; the same two above 1: none. */
  std::array<float, 2> AverageRange{ { -1, 2 } };
  std::vector<float> IsoValues;                // stored scalars, ascending, none twice
  std::vector<std::array<float, 4>> IsoColors; // r, g, b, opacity at each

  bool isComposite() const { return this->Mode == BlendMode::Composite; }
  bool isSum() const
  {
    return this->Mode == BlendMode::Average || this->Mode == BlendMode::Additive;
  }
  bool isIsoSurface() const { return this->Mode == BlendMode::IsoSurface; }
  /** Times which scalars are the greater, the more they are shown. */
  float extremeSign() const { return this->Mode == BlendMode::Minimum ? -1.0f : 1.0f; }
  void setBits(VariantKey& key) const;
};

/** What a user asks for. */
struct BlendOptions
{
  int Mode = 0;                         // a BlendMode
  std::array<double, 2> AverageRange{}; // of the data's scalars
};

/** Of the stored scalars of that range. Returns an empty string, or what is wrong and what to do.
 */
std::string makeBlending(const BlendOptions& options, vtkVolumeProperty* property,
  const ScalarRange& range, Blending& made);

/** What is in it: equal if it shows the same. */
Fingerprint versionOf(const Blending& blending);

/**
 * The table of the property: of composites as it is, under that law. Else its extinction is the
 * opacity itself; and for sums its colour is the intensity, 0 at the range's low end and 1 at its
 * high one.
 */
IntegralTable blendedTable(vtkVolumeProperty* property, OpacityLaw law, const Blending& blending,
  const ScalarRange& range, const AccuracyLevel& level);

} // namespace tetmarch

#endif
