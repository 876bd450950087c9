// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Appearance/VectorOptions.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkVolumeProperty.h"

namespace tetmarch
{
namespace
{

// Asking for a colour function where there is a gray one would put it in its place.
bool followsColors(const VectorOptions& choice, vtkVolumeProperty* property)
{
  return choice.Mode == VectorMode::Disabled && property->GetColorChannels() == 3 &&
         property->GetIndependentComponents();
}

VectorOptions choiceOf(vtkColorTransferFunction* colors)
{
  return colors->GetVectorMode() == vtkScalarsToColors::MAGNITUDE
           ? VectorOptions{ VectorMode::Magnitude, 0 }
           : VectorOptions{ VectorMode::Component, colors->GetVectorComponent() };
}

std::string describeMissing(int component, vtkDataArray* array, const char* what)
{
  const int count = array->GetNumberOfComponents();
  return std::string("The scalar array \"") + (array->GetName() ? array->GetName() : "") +
         "\" has no component " + std::to_string(component) + ", which " + what +
         " asks for: it has " + std::to_string(count) + ", of which the first is 0.";
}

} // namespace

TupleScalar tupleScalarOf(
  const VectorOptions& choice, vtkVolumeProperty* property, vtkDataArray* array, std::string& error)
{
  error.clear();
  const int count = array->GetNumberOfComponents();
  const bool ofColors = followsColors(choice, property);
  if (choice.Mode != VectorMode::Component && count == 1)
  {
    return {};
  }
  const VectorOptions made = ofColors ? choiceOf(property->GetRGBTransferFunction()) : choice;
  if (made.Mode != VectorMode::Component)
  {
    return { made.Mode == VectorMode::Magnitude, 0 };
  }
  if (made.Component < 0 || made.Component >= count)
  {
    error = describeMissing(made.Component, array,
      ofColors ? "the colour function (SetVectorComponent)" : "VectorComponent");
    return {};
  }
  return { false, made.Component };
}

} // namespace tetmarch
