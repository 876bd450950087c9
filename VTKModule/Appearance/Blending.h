// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The blend mode of the scalars along a ray.
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

/** The size of the array in Shaders/gather/blend_buffers.glsl. */
constexpr int MostIsoSurfaces = 32;

struct Blending
{
  BlendMode Mode = BlendMode::Composite;
  /** The range of the included stored scalars (0..1): a part of them for averages, else all. Two
   * equal numbers above 1: none. */
  std::array<float, 2> AverageRange{ { -1, 2 } };
  std::vector<float> IsoValues;                // stored scalars, ascending, distinct
  std::vector<std::array<float, 4>> IsoColors; // r, g, b, opacity at each

  bool isComposite() const { return this->Mode == BlendMode::Composite; }
  bool isSum() const
  {
    return this->Mode == BlendMode::Average || this->Mode == BlendMode::Additive;
  }
  bool isIsoSurface() const { return this->Mode == BlendMode::IsoSurface; }
  /** The factor with which the shown scalar is the maximum. */
  float extremeSign() const { return this->Mode == BlendMode::Minimum ? -1.0f : 1.0f; }
  void setBits(VariantKey& key) const;
};

/** The user's settings. */
struct BlendOptions
{
  int Mode = 0;                         // a BlendMode
  std::array<double, 2> AverageRange{}; // of the data's scalars
};

/** Blending of the stored scalars of that range. Returns an empty string, or an error with its
 * remedy. */
std::string makeBlending(const BlendOptions& options, vtkVolumeProperty* property,
  const ScalarRange& range, Blending& made);

/** Equal if the blending is the same. */
Fingerprint versionOf(const Blending& blending);

/**
 * The table of the property. For composites its extinction follows from the opacity by the law;
 * otherwise it is the opacity itself. For sums its colour is the intensity: 0 at the low end of the
 * range and 1 at the high end.
 */
IntegralTable blendedTable(vtkVolumeProperty* property, OpacityLaw law, const Blending& blending,
  const ScalarRange& range, const AccuracyLevel& level);

} // namespace tetmarch

#endif
