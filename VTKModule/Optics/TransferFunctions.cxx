// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Optics/TransferFunctions.h"

#include "Optics/BinAreas.h"
#include "Parallel/ParallelFor.h"

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

// Take `count` samples of the extinction from begin to end.
std::vector<double> extinctions(
  vtkVolumeProperty* property, OpacityLaw law, double begin, double end, int count)
{
  std::vector<double> values(count);
  property->GetScalarOpacity()->GetTable(begin, end, count, values.data());
  for (double& value : values)
  {
    value = extinctionOf(value, law);
  }
  return values;
}

// A table of VTK 9.1 is black exactly at the first node of the function, unless it begins there.
void correctFirstNode(vtkColorTransferFunction* function, double begin, double end, int count,
  std::vector<double>& colors)
{
  const double node = function->GetRange()[0];
  const double place = count > 1 ? (node - begin) / (end - begin) * (count - 1) : 0.0;
  const double nearest = std::round(place);
  if (nearest > 0 && nearest < count && std::abs(place - nearest) < 1e-6)
  {
    function->GetColor(node, &colors[3 * static_cast<std::size_t>(nearest)]);
  }
}

// Take `count` samples of both functions from begin to end.
std::vector<OpticalSample> evaluate(
  vtkVolumeProperty* property, OpacityLaw law, double begin, double end, int count)
{
  std::vector<double> colors(3 * static_cast<std::size_t>(count));
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
    correctFirstNode(property->GetRGBTransferFunction(), begin, end, count, colors);
  }
  const std::vector<double> extinction = extinctions(property, law, begin, end, count);
  std::vector<OpticalSample> samples(count);
  for (int i = 0; i < count; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      samples[i][k] =
        std::min(std::max(0.0, colors[3 * static_cast<std::size_t>(i) + k]), 1.0); // NaN: 0
    }
    samples[i][3] = extinction[i];
  }
  return samples;
}

// The deviation of the line between two kept samples from the fine ones; for extinctions relative
// to the maximum.
double deviation(const OpticalSample* fine, std::size_t perBin, const OpticalSample& p,
  const OpticalSample& q, double greatest)
{
  double most = 0;
  for (std::size_t i = 0; i < perBin; ++i)
  {
    const double share = static_cast<double>(i) / static_cast<double>(perBin);
    const auto difference = [&](int k)
    { return std::abs(p[k] + (q[k] - p[k]) * share - fine[i][k]); };
    most = std::max(most, difference(3) / greatest);
    for (int k = 0; k < 3 && fine[i][3] > 0; ++k)
    {
      most = std::max(most, difference(k));
    }
  }
  return most;
}

double deviation(const std::vector<OpticalSample>& fine, const std::vector<OpticalSample>& kept,
  std::size_t perBin)
{
  double greatest = 0;
  for (const OpticalSample& s : fine)
  {
    greatest = std::max(greatest, s[3]);
  }
  if (!(greatest > 0))
  {
    return 0;
  }
  std::vector<double> ofBins(kept.size() - 1);
  parallelFor(0, static_cast<vtkIdType>(ofBins.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (std::size_t i = first; i < static_cast<std::size_t>(last); ++i)
      {
        ofBins[i] = deviation(&fine[i * perBin], perBin, kept[i], kept[i + 1], greatest);
      }
    });
  return *std::max_element(ofBins.begin(), ofBins.end());
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
  // There are no nodes within the data, or only in so small a part that positions in the table
  // would overflow in float.
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

std::array<float, 4> nanColorOf(vtkVolumeProperty* property, OpacityLaw law)
{
  std::array<float, 4> color{};
  if (property->GetColorChannels() != 1)
  {
    vtkColorTransferFunction* function = property->GetRGBTransferFunction();
    for (int k = 0; k < 3; ++k)
    {
      color[k] = static_cast<float>(std::min(std::max(0.0, function->GetNanColor()[k]), 1.0));
    }
    color[3] = static_cast<float>(extinctionOf(function->GetNanOpacity(), law));
  }
  return color;
}

SampledFunctions refined(
  vtkVolumeProperty* property, OpacityLaw law, const SampledFunctions& coarse, int factor)
{
  SampledFunctions fine = coarse;
  const int count = (static_cast<int>(coarse.Samples.size()) - 1) * factor + 1;
  const std::vector<double> extinction =
    extinctions(property, law, coarse.Begin, coarse.End, count);
  fine.Samples.resize(count);
  for (int i = 0; i < count; ++i)
  {
    const OpticalSample& p = coarse.Samples[i / factor];
    const OpticalSample& q = coarse.Samples[(i + factor - 1) / factor];
    const double share = static_cast<double>(i % factor) / factor;
    for (int k = 0; k < 3; ++k)
    {
      fine.Samples[i][k] = p[k] + (q[k] - p[k]) * share;
    }
    fine.Samples[i][3] = extinction[i];
  }
  return fine;
}

SampledFunctions keepAreas(const SampledFunctions& fine, int perBin)
{
  SampledFunctions functions = fine;
  functions.Samples = keepBinAreas(fine.Samples, perBin);
  functions.Deviation = deviation(fine.Samples, functions.Samples, perBin);
  return functions;
}

} // namespace tetmarch
