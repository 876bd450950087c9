// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Appearance/Blending.h"

#include "Scalars/StoredScalar.h"
#include "Variants/VariantKey.h"

#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

double storedOf(double scalar, const ScalarRange& range)
{
  return (scalar - range.Low) / range.width();
}

std::array<float, 2> storedRange(const std::array<double, 2>& scalars, const ScalarRange& range)
{
  if (!(scalars[0] <= scalars[1]))
  {
    return { { 3, 3 } };
  }
  const auto stored = [&](double scalar)
  { return static_cast<float>(std::min(std::max(storedOf(scalar, range), -1.0), 2.0)); };
  return { { stored(scalars[0]), stored(scalars[1]) } };
}

std::array<float, 4> colorAt(vtkVolumeProperty* property, double scalar)
{
  std::array<double, 3> rgb{};
  if (property->GetColorChannels() == 1)
  {
    rgb.fill(property->GetGrayTransferFunction()->GetValue(scalar));
  }
  else
  {
    property->GetRGBTransferFunction()->GetColor(scalar, rgb.data());
  }
  std::array<float, 4> color{};
  const auto inUnit = [](double x)
  { return static_cast<float>(std::min(std::max(0.0, x), 1.0)); }; // NaN: 0
  std::transform(rgb.begin(), rgb.end(), color.begin(), inUnit);
  color[3] = inUnit(property->GetScalarOpacity()->GetValue(scalar));
  return color;
}

std::string addIsoSurfaces(vtkVolumeProperty* property, const ScalarRange& range, Blending& made)
{
  vtkContourValues* contours = property->GetIsoSurfaceValues();
  std::vector<double> values;
  for (int i = 0; i < contours->GetNumberOfContours(); ++i)
  {
    if (std::isfinite(contours->GetValue(i)))
    {
      values.push_back(contours->GetValue(i));
    }
  }
  std::sort(values.begin(), values.end());
  for (double value : values)
  {
    const auto stored = static_cast<float>(storedOf(value, range));
    if (made.IsoValues.empty() || stored > made.IsoValues.back())
    {
      made.IsoValues.push_back(stored);
      made.IsoColors.push_back(colorAt(property, value));
    }
  }
  return made.IsoValues.size() <= MostIsoSurfaces
           ? std::string()
           : "There are " + std::to_string(made.IsoValues.size()) +
               " isosurface values, but at most " + std::to_string(MostIsoSurfaces) +
               " can be drawn (vtkVolumeProperty::GetIsoSurfaceValues()).";
}

} // namespace

void Blending::setBits(VariantKey& key) const
{
  key.Blend = this->isComposite()    ? BlendGroup::Composite
              : this->isSum()        ? BlendGroup::Sum
              : this->isIsoSurface() ? BlendGroup::Isosurfaces
                                     : BlendGroup::Extreme;
}

std::string makeBlending(const BlendOptions& options, vtkVolumeProperty* property,
  const ScalarRange& range, Blending& made)
{
  made = {};
  if (options.Mode < 0 || options.Mode > static_cast<int>(BlendMode::IsoSurface))
  {
    return "The blend mode is " + std::to_string(options.Mode) +
           ", but only composite (0), maximum (1) and minimum intensity (2), average intensity "
           "(3), "
           "additive (4) and isosurface (5) can be drawn.";
  }
  made.Mode = static_cast<BlendMode>(options.Mode);
  if (made.Mode == BlendMode::Average)
  {
    made.AverageRange = storedRange(options.AverageRange, range);
  }
  return made.isIsoSurface() ? addIsoSurfaces(property, range, made) : std::string();
}

Fingerprint versionOf(const Blending& blending)
{
  Fingerprint version{ static_cast<std::uintptr_t>(blending.Mode) };
  addAll(version, blending.AverageRange);
  addAll(version, blending.IsoValues);
  for (const auto& color : blending.IsoColors)
  {
    addAll(version, color);
  }
  return version;
}

IntegralTable blendedTable(vtkVolumeProperty* property, OpacityLaw law, const Blending& blending,
  const ScalarRange& range, const AccuracyLevel& level)
{
  if (blending.isComposite())
  {
    return fittingTable(property, law, range.Low, range.High, level);
  }
  if (!blending.isSum())
  {
    return fittingTable(property, OpacityLaw::Unstructured, range.Low, range.High, level);
  }
  vtkNew<vtkPiecewiseFunction> intensity;
  intensity->AddPoint(range.Low, 0.0);
  intensity->AddPoint(range.Low + range.width(), 1.0);
  vtkNew<vtkVolumeProperty> gray;
  gray->SetColor(intensity);
  gray->SetScalarOpacity(property->GetScalarOpacity());
  return fittingTable(gray, OpacityLaw::Unstructured, range.Low, range.High, level);
}

} // namespace tetmarch
