// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Functions.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetmarch::bench
{
namespace
{
constexpr double TwoPi = 6.283185307179586;

double at(const FunctionRange& range, double share)
{
  return range.Low + share * (range.High - range.Low);
}

// Enough nodes for their kinks to be seen nowhere.
void setSmooth(const FunctionRange& range, vtkVolumeProperty* property)
{
  constexpr int nodes = 129;
  constexpr double mostOpacity = 0.6;
  for (int i = 0; i < nodes; ++i)
  {
    const double share = static_cast<double>(i) / (nodes - 1);
    const double s = at(range, share);
    const auto wave = [share](double shift)
    { return 0.5 + 0.5 * std::cos(TwoPi * (share - shift)); };
    property->GetRGBTransferFunction()->AddRGBPoint(s, wave(0.0), wave(1.0 / 3), wave(2.0 / 3));
    property->GetScalarOpacity()->AddPoint(s, mostOpacity * (1.0 - wave(0.0)));
  }
}

void setRamp(const FunctionRange& range, vtkVolumeProperty* property)
{
  vtkColorTransferFunction* color = property->GetRGBTransferFunction();
  color->SetColorSpaceToDiverging();
  color->AddRGBPoint(range.Low, 0.231373, 0.298039, 0.752941);
  color->AddRGBPoint(at(range, 0.5), 0.865003, 0.865003, 0.865003);
  color->AddRGBPoint(range.High, 0.705882, 0.0156863, 0.14902);
  property->GetScalarOpacity()->AddPoint(range.Low, 0.0);
  property->GetScalarOpacity()->AddPoint(range.High, 1.0);
}

void setSpikes(const FunctionRange& range, vtkVolumeProperty* property)
{
  constexpr double halfWidth = 0.005;
  constexpr double denser = 10.0;
  constexpr std::array<std::array<double, 3>, 5> colors{ { { { 0.2, 0.3, 1.0 } },
    { { 0.1, 0.9, 0.9 } }, { { 0.3, 0.9, 0.2 } }, { { 1.0, 0.9, 0.1 } }, { { 1.0, 0.2, 0.1 } } } };
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  opacity->AddPoint(range.Low, 0.0);
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    const double peak = (2.0 * static_cast<double>(i) + 1.0) / (2.0 * colors.size());
    opacity->AddPoint(at(range, peak - halfWidth), 0.0);
    opacity->AddPoint(at(range, peak), 1.0);
    opacity->AddPoint(at(range, peak + halfWidth), 0.0);
    property->GetRGBTransferFunction()->AddRGBPoint(
      at(range, peak), colors[i][0], colors[i][1], colors[i][2]);
  }
  opacity->AddPoint(range.High, 0.0);
  property->SetScalarOpacityUnitDistance(range.UnitDistance / denser);
}
} // namespace

const std::string OwnFunctions = "own";

const std::vector<std::string>& commonFunctions()
{
  static const std::vector<std::string> names = { "smooth", "ramp", "spikes" };
  return names;
}

bool isFunctions(const std::string& name)
{
  const auto& names = commonFunctions();
  return name == OwnFunctions || std::find(names.begin(), names.end(), name) != names.end();
}

vtkSmartPointer<vtkVolumeProperty> propertyOf(const TransferFunctions& functions, double unit)
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetColor(functions.Color);
  property->SetScalarOpacity(functions.Opacity);
  property->SetScalarOpacityUnitDistance(unit);
  property->SetInterpolationTypeToLinear();
  property->ShadeOff();
  return property;
}

vtkSmartPointer<vtkVolumeProperty> wavesProperty(double unitDistance)
{
  TransferFunctions functions;
  functions.Color->AddRGBPoint(0.0, 0.1, 0.2, 0.8);
  functions.Color->AddRGBPoint(0.5, 0.9, 0.9, 0.9);
  functions.Color->AddRGBPoint(1.0, 0.8, 0.1, 0.1);
  functions.Opacity->AddPoint(0.0, 0.6);
  functions.Opacity->AddPoint(0.3, 0.1);
  functions.Opacity->AddPoint(0.5, 0.4);
  functions.Opacity->AddPoint(0.7, 0.1);
  functions.Opacity->AddPoint(1.0, 0.8);
  return propertyOf(functions, unitDistance);
}

vtkSmartPointer<vtkVolumeProperty> makeFunctions(
  const std::string& name, const FunctionRange& range)
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetScalarOpacityUnitDistance(range.UnitDistance);
  property->SetInterpolationTypeToLinear();
  property->ShadeOff();
  const auto set = name == "smooth" ? setSmooth : name == "ramp" ? setRamp : setSpikes;
  set(range, property);
  return property;
}
} // namespace tetmarch::bench
