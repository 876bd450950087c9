// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WebPage/FunctionJson.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <vector>

namespace tetmarch
{
namespace
{

constexpr int Samples = 512; // of a range

Json::Value listOf(std::initializer_list<double> numbers)
{
  Json::Value list(Json::arrayValue);
  for (const double x : numbers)
  {
    list.append(x);
  }
  return list;
}

// The samples of the part of a range that has nodes, and these nodes, where the function may have a
// step. It is constant beyond.
std::vector<double> placesOf(double low, double high, const std::vector<double>& nodes)
{
  std::vector<double> places;
  if (!nodes.empty())
  {
    low = std::clamp(nodes.front(), low, high);
    high = std::clamp(nodes.back(), low, high);
  }
  for (int i = 0; i <= Samples; ++i)
  {
    places.push_back(low + (high - low) * i / Samples);
  }
  std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(places),
    [&](double x) { return x > low && x < high; });
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

Json::Value colorsOf(vtkColorTransferFunction* function, double low, double high)
{
  std::vector<double> nodes;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    std::array<double, 6> node;
    function->GetNodeValue(i, node.data());
    nodes.push_back(node[0]);
  }
  Json::Value list(Json::arrayValue);
  for (const double x : placesOf(low, high, nodes))
  {
    std::array<double, 3> c;
    function->GetColor(x, c.data());
    list.append(listOf({ x, c[0], c[1], c[2] }));
  }
  return list;
}

// Points of a function that is linear between its nodes; else samples.
std::vector<std::array<double, 2>> pointsOf(vtkPiecewiseFunction* function, double low, double high)
{
  std::vector<std::array<double, 2>> points;
  std::vector<double> nodes;
  bool isLinear = !function->GetUseLogScale();
  for (int i = 0; i < function->GetSize(); ++i)
  {
    std::array<double, 4> node;
    function->GetNodeValue(i, node.data());
    nodes.push_back(node[0]);
    points.push_back({ { node[0], node[1] } });
    isLinear = isLinear && node[2] == 0.5 && node[3] == 0;
  }
  if (points.empty())
  {
    points.push_back({ { low, 0 } }); // as VTK evaluates a function without nodes
  }
  if (!function->GetClamping())
  {
    // The function is 0 beyond its nodes.
    points.insert(points.begin(), { { points.front()[0], 0 } });
    points.push_back({ { points.back()[0], 0 } });
  }
  if (!isLinear)
  {
    points.clear();
    for (const double x : placesOf(low, high, nodes))
    {
      points.push_back({ { x, function->GetValue(x) } });
    }
  }
  return points;
}

} // namespace

Json::Value functionsOf(vtkVolumeProperty* property, int component, double low, double high)
{
  Json::Value functions;
  if (property->GetColorChannels(component) == 1)
  {
    functions["color"] = Json::Value(Json::arrayValue);
    for (const auto& [x, gray] : pointsOf(property->GetGrayTransferFunction(component), low, high))
    {
      functions["color"].append(listOf({ x, gray, gray, gray }));
    }
    functions["nan"] = listOf({ 0, 0, 0, 0 });
  }
  else
  {
    vtkColorTransferFunction* colors = property->GetRGBTransferFunction(component);
    const double* nan = colors->GetNanColor();
    functions["color"] = colorsOf(colors, low, high);
    functions["nan"] = listOf({ nan[0], nan[1], nan[2], colors->GetNanOpacity() });
  }
  functions["opacity"] = Json::Value(Json::arrayValue);
  for (const auto& [x, opacity] : pointsOf(property->GetScalarOpacity(component), low, high))
  {
    functions["opacity"].append(listOf({ x, opacity }));
  }
  return functions;
}

} // namespace tetmarch
