// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the user asked of light beside the mapper's settings, and how it comes into the scene.
 */
#ifndef tetmarch_LightOptions_h
#define tetmarch_LightOptions_h

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkRenderer;
class vtkVolumeProperty;

namespace tetmarch
{

/// Directional, from where it shines, or at the eye.
struct LightOption
{
  std::optional<std::array<double, 3>> From; // none: a headlight
  double Intensity = 1.0;
};

/// What isn't given stays as VTK has it.
struct LightOptions
{
  bool Shade = false;
  std::vector<LightOption> Lights; // none: a headlight
  std::optional<double> Ambient;
  std::optional<double> Diffuse;
  std::optional<double> Specular;
  std::optional<double> SpecularPower;
};

/// Throws UsageError. `value` is "X,Y,Z" or "headlight", either with ",INTENSITY" behind it.
LightOption ParseLight(const std::string& value);

void SetUpLight(const LightOptions& options, vtkRenderer* renderer, vtkVolumeProperty* property);

} // namespace tetmarch

#endif
