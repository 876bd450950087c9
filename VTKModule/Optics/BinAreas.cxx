// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BinAreas.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

// C tau and tau, which add up, of a sample.
OpticalSample weighted(const OpticalSample& s)
{
  return { { s[0] * s[3], s[1] * s[3], s[2] * s[3], s[3] } };
}

// The least and the greatest of each component.
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

// A sample to be corrected: what it is, and between which values the functions run in its two bins.
struct Node
{
  OpticalSample Value;
  bool IsFixed =
    false; // the first and the last: values that many points of the data may have exactly
  Span Weighted;
  Span Seen; // colours where there is extinction
};

std::vector<Node> nodesOf(const std::vector<OpticalSample>& fine, std::size_t perBin)
{
  std::vector<Node> nodes;
  for (std::size_t at = 0; at < fine.size(); at += perBin)
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
    nodes.push_back(node);
  }
  return nodes;
}

// An amount is added to both ends, half each or as far as they may change: nothing gets greater or
// less than what it stands for.
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
  std::vector<Node> nodes = nodesOf(fine, perBin);
  for (std::size_t bin = 0; bin + 1 < nodes.size(); ++bin)
  {
    const std::size_t begin = bin * perBin, end = begin + perBin;
    std::array<double, 4> missing = linearIntegrals(fine[begin], fine[end]);
    for (double& x : missing)
    {
      x = -x;
    }
    for (std::size_t i = begin; i < end; ++i)
    {
      const std::array<double, 4> piece = linearIntegrals(fine[i], fine[i + 1]);
      for (int k = 0; k < 4; ++k)
      {
        missing[k] += piece[k] / perBin;
      }
    }
    // Where the functions are linear, what is left is rounding, of which no colour can be told.
    const bool linear =
      std::all_of(missing.begin(), missing.end(), [](double x) { return std::abs(x) < 1e-12; });
    for (int k = 0; k < 4 && !linear; ++k)
    {
      addToEnds(missing[k], k, nodes[bin], nodes[bin + 1]);
    }
  }
  std::vector<OpticalSample> kept;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    OpticalSample s = nodes[i].Value;
    for (int k = 0; k < 3; ++k)
    {
      s[k] = s[3] > 0 ? nodes[i].Seen.clamped(s[k] / s[3], k) : fine[i * perBin][k];
    }
    kept.push_back(s);
  }
  return kept;
}

} // namespace tetmarch
