// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StructuredFunctions.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetmarch::bench
{
namespace
{
constexpr double TwoPi = 6.283185307179586;
constexpr double MostOpacity = 0.9;

/// Functions of its own, without the nodes that VTK's defaults have; shares of the range.
class Points
{
public:
  explicit Points(const FunctionRange& range)
    : Range(range)
  {
  }

  void addColor(double share, double red, double green, double blue)
  {
    this->Color->AddRGBPoint(this->at(share), red, green, blue);
  }
  void addOpacity(double share, double opacity)
  {
    this->Opacity->AddPoint(this->at(share), opacity);
  }

  vtkSmartPointer<vtkVolumeProperty> property(double unitDistance) const
  {
    auto property = vtkSmartPointer<vtkVolumeProperty>::New();
    property->SetColor(this->Color);
    property->SetScalarOpacity(this->Opacity);
    property->SetScalarOpacityUnitDistance(unitDistance);
    property->SetInterpolationTypeToLinear();
    property->ShadeOff();
    return property;
  }

private:
  double at(double share) const
  {
    return this->Range.Low + share * (this->Range.High - this->Range.Low);
  }

  FunctionRange Range;
  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkPiecewiseFunction> Opacity;
};

vtkSmartPointer<vtkVolumeProperty> makeRamp(const FunctionRange& range)
{
  constexpr double begin = 0.1;
  Points functions(range);
  functions.addColor(0.0, 0.231373, 0.298039, 0.752941);
  functions.addColor(0.5, 0.865003, 0.865003, 0.865003);
  functions.addColor(1.0, 0.705882, 0.0156863, 0.14902);
  functions.addOpacity(0.0, 0.0);
  functions.addOpacity(begin, 0.0);
  functions.addOpacity(1.0, MostOpacity);
  return functions.property(range.UnitDistance);
}

vtkSmartPointer<vtkVolumeProperty> makePeaks(const FunctionRange& range)
{
  constexpr double halfWidth = 0.005;
  constexpr double denser = 10.0;
  constexpr std::array<std::array<double, 3>, 5> colors{ { { { 0.2, 0.3, 1.0 } },
    { { 0.1, 0.9, 0.9 } }, { { 0.3, 0.9, 0.2 } }, { { 1.0, 0.9, 0.1 } }, { { 1.0, 0.2, 0.1 } } } };
  Points functions(range);
  functions.addOpacity(0.0, 0.0);
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    const double peak = (2.0 * static_cast<double>(i) + 1.0) / (2.0 * colors.size());
    functions.addOpacity(peak - halfWidth, 0.0);
    functions.addOpacity(peak, MostOpacity);
    functions.addOpacity(peak + halfWidth, 0.0);
    functions.addColor(peak, colors[i][0], colors[i][1], colors[i][2]);
  }
  functions.addOpacity(1.0, 0.0);
  return functions.property(range.UnitDistance / denser);
}

// Enough nodes for their kinks to be seen nowhere. Thinner than the others, since all of it shows.
vtkSmartPointer<vtkVolumeProperty> makeSmooth(const FunctionRange& range)
{
  constexpr int nodes = 129;
  constexpr double leastOpacity = 0.02;
  constexpr double amplitude = 0.3;
  constexpr double thinner = 3.0;
  Points functions(range);
  for (int i = 0; i < nodes; ++i)
  {
    const double share = static_cast<double>(i) / (nodes - 1);
    const auto wave = [share](double shift)
    { return 0.5 + 0.5 * std::cos(TwoPi * (share - shift)); };
    functions.addColor(share, wave(0.0), wave(1.0 / 3), wave(2.0 / 3));
    functions.addOpacity(share, leastOpacity + amplitude * (1.0 - wave(0.0)));
  }
  return functions.property(thinner * range.UnitDistance);
}
} // namespace

const std::vector<std::string>& structuredFunctions()
{
  static const std::vector<std::string> names = { "ramp", "peaks", "smooth" };
  return names;
}

bool isStructuredFunctions(const std::string& name)
{
  const auto& names = structuredFunctions();
  return std::find(names.begin(), names.end(), name) != names.end();
}

vtkSmartPointer<vtkVolumeProperty> makeStructuredFunctions(
  const std::string& name, const FunctionRange& range)
{
  const auto make = name == "ramp" ? makeRamp : name == "peaks" ? makePeaks : makeSmooth;
  return make(range);
}
} // namespace tetmarch::bench
