// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Optics/IntegralTable.h"

#include "Optics/BinAreas.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

using Integral = std::array<double, 4>; // C tau, tau

// A colour without extinction is invisible. It is replaced by that of the nearest entry with
// extinction, so that it doesn't count as a change of colour.
void hideUnseenColours(std::vector<OpticalSample>& entries)
{
  const auto isSeen = [&](std::size_t i)
  {
    return entries[i][3] > 0 || (i > 0 && entries[i - 1][3] > 0) ||
           (i + 1 < entries.size() && entries[i + 1][3] > 0);
  };
  std::vector<std::size_t> seen;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    if (isSeen(i))
    {
      seen.push_back(i);
    }
  }
  std::size_t next = 0; // of seen
  for (std::size_t i = 0; i < entries.size() && !seen.empty(); ++i)
  {
    const auto distance = [i](std::size_t j) { return j > i ? j - i : i - j; };
    while (next + 1 < seen.size() && distance(seen[next + 1]) <= distance(seen[next]))
    {
      ++next;
    }
    std::copy_n(entries[seen[next]].begin(), 3, entries[i].begin());
  }
}

// The maximum change of a channel from one entry to the next.
double colourChange(const OpticalSample& p, const OpticalSample& q)
{
  double most = 0;
  for (int k = 0; k < 3; ++k)
  {
    most = std::max(most, std::abs(q[k] - p[k]));
  }
  return most;
}

} // namespace

double IntegralTable::scale(double width) const
{
  return width / (this->End - this->Begin) * (this->size() - 5);
}

double IntegralTable::offset(double low) const
{
  return 2 + (low - this->Begin) / (this->End - this->Begin) * (this->size() - 5);
}

IntegralTable makeIntegralTable(const SampledFunctions& functions)
{
  std::vector<OpticalSample> entries(2, functions.Before);
  entries.insert(entries.end(), functions.Samples.begin(), functions.Samples.end());
  entries.insert(entries.end(), 2, functions.After);

  hideUnseenColours(entries);

  std::vector<Integral> integrals(entries.size(), Integral{});
  for (std::size_t i = 1; i < entries.size(); ++i)
  {
    const Integral bin = linearIntegrals(entries[i - 1], entries[i]);
    for (int k = 0; k < 4; ++k)
    {
      integrals[i][k] = integrals[i - 1][k] + bin[k];
    }
  }

  IntegralTable table;
  table.Begin = functions.Begin;
  table.End = functions.End;
  constexpr double Most = 4294967295.0;
  Integral unit;
  for (int k = 0; k < 4; ++k)
  {
    unit[k] = integrals.back()[k] / Most;
  }
  table.IntegralUnit = { { unit[0], unit[1], unit[2], unit[3] } };
  double variation = 0;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    std::array<float, 4> value;
    std::array<std::uint32_t, 4> fixed{};
    for (int k = 0; k < 4; ++k)
    {
      fixed[k] = unit[k] > 0 ? static_cast<std::uint32_t>(
                                 std::min(std::floor(integrals[i][k] / unit[k] + 0.5), Most))
                             : 0;
    }
    for (int k = 0; k < 4; ++k)
    {
      value[k] = static_cast<float>(entries[i][k]);
    }
    table.Values.push_back(value);
    table.Integrals.push_back(fixed);
    variation += i > 0 ? colourChange(entries[i - 1], entries[i]) : 0;
    table.Variations.push_back(static_cast<float>(variation));
  }
  table.Traits = traitsOf(table.Values);
  return table;
}

bool hasExtinction(const IntegralTable& table)
{
  return std::any_of(table.Values.begin(), table.Values.end(),
    [](const std::array<float, 4>& v) { return v[3] > 0; });
}

void addExtinctionVariations(IntegralTable& table)
{
  double variation = 0;
  table.ExtinctionVariations.clear();
  for (std::size_t i = 0; i < table.Values.size(); ++i)
  {
    variation += i > 0 ? std::abs(double(table.Values[i][3]) - double(table.Values[i - 1][3])) : 0;
    table.ExtinctionVariations.push_back(static_cast<float>(variation));
  }
}

void addSlopeVariations(IntegralTable& table)
{
  using Slopes = std::array<double, 4>; // of C tau and tau
  // The slope of the parabola C tau at the begin (end 0) or end (end 1) of a bin.
  const auto slopesAt = [&](std::size_t bin, int end)
  {
    const std::array<float, 4>& from = table.Values[bin];
    const std::array<float, 4>& to = table.Values[bin + 1];
    const std::array<float, 4>& at = end == 0 ? from : to;
    const double rise = double(to[3]) - double(from[3]);
    Slopes slopes{};
    for (int k = 0; k < 3; ++k)
    {
      slopes[k] = (double(to[k]) - double(from[k])) * double(at[3]) + double(at[k]) * rise;
    }
    slopes[3] = rise;
    return slopes;
  };
  double ofExtinction = 0;
  double ofEmission = 0;
  const auto add = [&](const Slopes& before, const Slopes& behind)
  {
    double most = 0;
    for (int k = 0; k < 3; ++k)
    {
      most = std::max(most, std::abs(behind[k] - before[k]));
    }
    ofEmission += most;
    ofExtinction += std::abs(behind[3] - before[3]);
  };
  table.SlopeVariations.assign(1, {});
  Slopes before{}; // all is constant before the first bin
  for (std::size_t bin = 0; bin + 1 < table.Values.size(); ++bin)
  {
    const Slopes begin = slopesAt(bin, 0);
    add(before, begin);
    // The sums up to a bin include the jump at its begin.
    table.SlopeVariations[bin] = { { static_cast<float>(ofExtinction),
      static_cast<float>(ofEmission) } };
    before = slopesAt(bin, 1);
    add(begin, before);
    table.SlopeVariations.push_back(table.SlopeVariations.back());
  }
}

} // namespace tetmarch
