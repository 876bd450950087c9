// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Optics/BinAreas.h"

#include "Parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

// C tau and tau of a sample, which are additive.
OpticalSample weighted(const OpticalSample& s)
{
  return { { s[0] * s[3], s[1] * s[3], s[2] * s[3], s[3] } };
}

// The minimum and maximum of each component.
struct Span
{
  OpticalSample Least{ { 1e300, 1e300, 1e300, 1e300 } };
  OpticalSample Most{ { -1e300, -1e300, -1e300, -1e300 } };

  void add(const OpticalSample& s)
  {
    for (int k = 0; k < 4; ++k)
    {
      this->Least[k] = std::min(this->Least[k], s[k]);
      this->Most[k] = std::max(this->Most[k], s[k]);
    }
  }
  double clamped(double x, int k) const
  {
    return std::min(std::max(x, this->Least[k]), this->Most[k]);
  }
};

// A sample to be corrected: its value, and the span of the functions in its two bins.
struct Node
{
  OpticalSample Value;
  bool IsFixed = false; // the first and the last sample: frequent values of the data
  Span Weighted;
  Span Seen; // colours with extinction
};

Node nodeAt(const std::vector<OpticalSample>& fine, std::size_t at, std::size_t perBin)
{
  Node node{ weighted(fine[at]), at == 0 || at + 1 == fine.size(), {}, {} };
  const std::size_t end = std::min(at + perBin + 1, fine.size());
  for (std::size_t i = at < perBin ? 0 : at - perBin; i < end; ++i)
  {
    node.Weighted.add(weighted(fine[i]));
    if (fine[i][3] > 0)
    {
      node.Seen.add(fine[i]);
    }
  }
  return node;
}

// The colour and extinction of a node; `fine` is its original sample.
OpticalSample unweighted(const Node& node, const OpticalSample& fine)
{
  OpticalSample s = node.Value;
  for (int k = 0; k < 3; ++k)
  {
    s[k] = s[3] > 0 ? node.Seen.clamped(s[k] / s[3], k) : fine[k];
  }
  return s;
}

// The difference between the integrals of the fine samples and those between two kept ones.
std::array<double, 4> missingBetween(
  const std::vector<OpticalSample>& fine, std::size_t begin, std::size_t end)
{
  std::array<double, 4> missing{};
  for (std::size_t i = begin; i < end; ++i)
  {
    const std::array<double, 4> piece = linearIntegrals(fine[i], fine[i + 1]);
    for (int k = 0; k < 4; ++k)
    {
      missing[k] += piece[k];
    }
  }
  const std::array<double, 4> line = linearIntegrals(fine[begin], fine[end]);
  for (int k = 0; k < 4; ++k)
  {
    missing[k] = missing[k] / static_cast<double>(end - begin) - line[k];
  }
  return missing;
}

// An amount is added to both ends, half each, or as far as they stay within the span of their fine
// samples.
void addToEnds(double amount, int k, Node& left, Node& right)
{
  const auto add = [k](double x, Node& node)
  {
    const double before = node.Value[k];
    node.Value[k] = node.IsFixed ? before : node.Weighted.clamped(before + x, k);
    return node.Value[k] - before;
  };
  const double added = add(0.5 * amount, left);
  const double rest = amount - added;
  add(rest - add(rest, right), left);
}

} // namespace

std::array<double, 4> linearIntegrals(const OpticalSample& p, const OpticalSample& q)
{
  std::array<double, 4> sum{};
  for (int k = 0; k < 3; ++k)
  {
    sum[k] = (p[k] * (2 * p[3] + q[3]) + q[k] * (p[3] + 2 * q[3])) / 6;
  }
  sum[3] = 0.5 * (p[3] + q[3]);
  return sum;
}

std::vector<OpticalSample> keepBinAreas(const std::vector<OpticalSample>& fine, int perBin)
{
  const std::size_t stride = perBin;
  const std::size_t bins = (fine.size() - 1) / stride;
  std::vector<std::array<double, 4>> missing(bins);
  std::vector<unsigned char> isBent(bins + 2); // bin i at i + 1
  parallelFor(0, static_cast<vtkIdType>(bins),
    [&](vtkIdType first, vtkIdType last)
    {
      for (std::size_t i = first; i < static_cast<std::size_t>(last); ++i)
      {
        missing[i] = missingBetween(fine, i * stride, (i + 1) * stride);
        // If the functions are linear, the remainder is rounding, which has no colour.
        isBent[i + 1] = std::any_of(
          missing[i].begin(), missing[i].end(), [](double x) { return !(std::abs(x) < 1e-12); });
      }
    });

  // Functions are mostly linear: only nodes of other bins are corrected.
  const auto changes = [&](std::size_t i) { return isBent[i] || isBent[i + 1]; };
  const auto nodeOf = [&](std::size_t i)
  { return changes(i) ? nodeAt(fine, i * stride, stride) : Node{}; };
  std::vector<OpticalSample> kept(bins + 1);
  const auto keep = [&](std::size_t i, const Node& node)
  { kept[i] = changes(i) ? unweighted(node, fine[i * stride]) : fine[i * stride]; };
  Node left = nodeOf(0);
  for (std::size_t bin = 0; bin < bins; ++bin)
  {
    Node right = nodeOf(bin + 1);
    for (int k = 0; k < 4 && isBent[bin + 1]; ++k)
    {
      addToEnds(missing[bin][k], k, left, right);
    }
    keep(bin, left);
    left = right;
  }
  keep(bins, left);
  return kept;
}

} // namespace tetmarch
