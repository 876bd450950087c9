// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scalars/DrawnScalars.h"

#include "Scalars/TupleCheck.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkVolumeProperty.h"

#include <numeric>

namespace tetmarch
{
namespace
{

std::string describe(vtkDataArray* array)
{
  return std::string("The scalar array \"") + (array->GetName() ? array->GetName() : "") +
         "\" has ";
}

// The unit of unmapped red, green and blue in VTK (vtkMapper's VTK_COLOR_MODE_DIRECT_SCALARS).
double colorUnit(vtkDataArray* array)
{
  const int type = array->GetDataType();
  return type == VTK_FLOAT || type == VTK_DOUBLE ? 1.0 : 255.0;
}

std::string chooseDependent(DrawnScalars& drawn)
{
  const int count = drawn.Array->GetNumberOfComponents();
  if (count == 2)
  {
    drawn.Mix = ComponentMix::ColorAndOpacity;
    drawn.First = { false, 1 };
    drawn.Extra = { 0 };
    return {};
  }
  if (count == 4)
  {
    drawn.Mix = ComponentMix::DirectColor;
    drawn.First = { false, 3 };
    drawn.Extra = { 0, 1, 2 };
    drawn.ExtraUnit = colorUnit(drawn.Array);
    return {};
  }
  return describe(drawn.Array) + std::to_string(count) +
         " components, but dependent ones (vtkVolumeProperty::IndependentComponentsOff()) are "
         "either 2, for colour and opacity, or 4, for red, green, blue and opacity. Switch "
         "IndependentComponents on; then VectorMode can choose one.";
}

std::string chooseIndependent(DrawnScalars& drawn)
{
  const int count = drawn.Array->GetNumberOfComponents();
  if (count > MostComponents)
  {
    return describe(drawn.Array) + std::to_string(count) + " components, but at most " +
           std::to_string(MostComponents) +
           " independent ones can be drawn together. Choose one by VectorMode.";
  }
  drawn.Mix = ComponentMix::Independent;
  drawn.Extra.resize(count - 1);
  std::iota(drawn.Extra.begin(), drawn.Extra.end(), 1);
  return {};
}

// The getter of the colour function would replace a gray one.
bool followsColors(const VectorOptions& options, vtkVolumeProperty* property)
{
  return options.Mode == VectorMode::Disabled && property->GetColorChannels() == 3;
}

VectorOptions optionsOf(vtkColorTransferFunction* colors)
{
  return colors->GetVectorMode() == vtkScalarsToColors::MAGNITUDE
           ? VectorOptions{ VectorMode::Magnitude, 0 }
           : VectorOptions{ VectorMode::Component, colors->GetVectorComponent() };
}

std::string chooseSingle(
  const VectorOptions& options, vtkVolumeProperty* property, DrawnScalars& drawn)
{
  const int count = drawn.Array->GetNumberOfComponents();
  if (options.Mode != VectorMode::Component && count == 1)
  {
    return {};
  }
  const bool byColors = followsColors(options, property);
  const VectorOptions used = byColors ? optionsOf(property->GetRGBTransferFunction()) : options;
  if (used.Mode != VectorMode::Component)
  {
    drawn.First = { used.Mode == VectorMode::Magnitude, 0 };
    return {};
  }
  if (used.Component < 0 || used.Component >= count)
  {
    return describe(drawn.Array) + "no component " + std::to_string(used.Component) + ", which " +
           (byColors ? "the colour function (SetVectorComponent)" : "VectorComponent") +
           " asks for: it has " + std::to_string(count) + ", of which the first is 0.";
  }
  drawn.First = { false, used.Component };
  return {};
}

} // namespace

std::string checkScalars(vtkDataSet* data, vtkDataArray* array, bool ofCells)
{
  return checkTuples(data, array, ofCells);
}

std::string chooseScalars(vtkDataSet* data, vtkDataArray* array, bool ofCells,
  const VectorOptions& options, vtkVolumeProperty* property, DrawnScalars& drawn)
{
  drawn = {};
  drawn.Array = array;
  drawn.OfCells = ofCells;
  const std::string wrong = checkScalars(data, array, ofCells);
  if (!wrong.empty())
  {
    return wrong;
  }
  const bool several = array->GetNumberOfComponents() > 1;
  const bool all = options.Mode == VectorMode::AllComponents;
  if (several && !property->GetIndependentComponents() &&
      (all || options.Mode == VectorMode::Disabled))
  {
    return chooseDependent(drawn);
  }
  return several && all ? chooseIndependent(drawn) : chooseSingle(options, property, drawn);
}

Fingerprint versionOf(const DrawnScalars& drawn)
{
  Fingerprint version;
  add(version, drawn.Array);
  version.push_back(drawn.OfCells ? 1 : 0);
  version.push_back(static_cast<std::uintptr_t>(drawn.Mix));
  version.push_back(drawn.First.Magnitude ? 1 : 0);
  version.push_back(static_cast<std::uintptr_t>(drawn.First.Component));
  for (const FiniteRange& range : drawn.Whole)
  {
    add(version, range.low());
    add(version, range.high());
    version.push_back(range.isAllFinite() ? 1 : 0);
  }
  return version;
}

} // namespace tetmarch
