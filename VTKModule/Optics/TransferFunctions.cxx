// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TransferFunctions.h"

#include "BinAreas.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

using Range = std::array<double, 2>;

// The functions are looked at so many times for each sample that is kept.
constexpr int FinePerBin = 16;

Range nodeRange(vtkVolumeProperty* property)
{
  Range range;
  property->GetScalarOpacity()->GetRange(range.data());
  Range colors;
  if (property->GetColorChannels() == 1)
  {
    property->GetGrayTransferFunction()->GetRange(colors.data());
  }
  else
  {
    property->GetRGBTransferFunction()->GetRange(colors.data());
  }
  return { { std::min(range[0], colors[0]), std::max(range[1], colors[1]) } };
}

// count samples of both functions from begin to end.
std::vector<std::array<double, 4>> evaluate(
  vtkVolumeProperty* property, OpacityLaw law, double begin, double end, int count)
{
  std::vector<double> colors(3 * static_cast<std::size_t>(count));
  std::vector<double> opacities(count);
  property->GetScalarOpacity()->GetTable(begin, end, count, opacities.data());
  if (property->GetColorChannels() == 1)
  {
    std::vector<double> grays(count);
    property->GetGrayTransferFunction()->GetTable(begin, end, count, grays.data());
    for (int i = 0; i < count; ++i)
    {
      std::fill_n(&colors[3 * static_cast<std::size_t>(i)], 3, grays[i]);
    }
  }
  else if (property->GetRGBTransferFunction()->GetScale() == VTK_CTF_LOG10)
  {
    // GetTable() would take steps of equal ratio.
    for (int i = 0; i < count; ++i)
    {
      const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
      property->GetRGBTransferFunction()->GetColor(
        begin + share * (end - begin), &colors[3 * static_cast<std::size_t>(i)]);
    }
  }
  else
  {
    property->GetRGBTransferFunction()->GetTable(begin, end, count, colors.data());
  }
  std::vector<std::array<double, 4>> samples(count);
  for (int i = 0; i < count; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      samples[i][k] =
        std::min(std::max(0.0, colors[3 * static_cast<std::size_t>(i) + k]), 1.0); // NaN: 0
    }
    samples[i][3] = extinctionOf(opacities[i], law);
  }
  return samples;
}

} // namespace

double extinctionOf(double opacity, OpacityLaw law)
{
  const double alpha = std::min(std::max(opacity, 0.0), 1.0);
  return law == OpacityLaw::Unstructured
           ? alpha
           : -std::log1p(-std::min(alpha, 1.0 - std::ldexp(1.0, -24)));
}

SampledFunctions sampleFunctions(
  vtkVolumeProperty* property, OpacityLaw law, double low, double high, int count)
{
  SampledFunctions functions;
  const Range nodes = nodeRange(property);
  functions.Begin = std::max(low, nodes[0]);
  functions.End = std::min(high, nodes[1]);
  // Nodes in no part of the data, or in so small a part that positions in the table would overflow
  // in float.
  if (!(functions.End - functions.Begin > 1e-30 * (high - low)))
  {
    functions.Begin = low;
    functions.End = high > low ? high : low + std::max(1.0, std::abs(low));
  }
  functions.Samples = evaluate(property, law, functions.Begin, functions.End, count);
  functions.Before =
    low < functions.Begin ? evaluate(property, law, low, low, 1)[0] : functions.Samples.front();
  functions.After =
    high > functions.End ? evaluate(property, law, high, high, 1)[0] : functions.Samples.back();
  return functions;
}

SampledFunctions sampleAreas(
  vtkVolumeProperty* property, OpacityLaw law, double low, double high, int count)
{
  SampledFunctions functions =
    sampleFunctions(property, law, low, high, (count - 1) * FinePerBin + 1);
  functions.Samples = keepBinAreas(functions.Samples, FinePerBin);
  return functions;
}

} // namespace tetmarch
