// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IntegralTable.h"

#include "BinAreas.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

using Integral = std::array<double, 5>; // C tau, tau, |C|^2 tau

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

  std::vector<Integral> integrals(entries.size(), Integral{});
  for (std::size_t i = 1; i < entries.size(); ++i)
  {
    const Integral bin = linearIntegrals(entries[i - 1], entries[i]);
    for (int k = 0; k < 5; ++k)
    {
      integrals[i][k] = integrals[i - 1][k] + bin[k];
    }
  }

  IntegralTable table;
  table.Begin = functions.Begin;
  table.End = functions.End;
  constexpr double Most = 4294967295.0;
  Integral unit;
  for (int k = 0; k < 5; ++k)
  {
    unit[k] = integrals.back()[k] / Most;
  }
  table.IntegralUnit = { { unit[0], unit[1], unit[2], unit[3] } };
  table.SquareUnit = unit[4];
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    std::array<float, 4> value;
    std::array<std::uint32_t, 5> fixed{};
    for (int k = 0; k < 5; ++k)
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
    table.Integrals.push_back({ { fixed[0], fixed[1], fixed[2], fixed[3] } });
    table.SquareIntegrals.push_back(fixed[4]);
  }
  return table;
}

} // namespace tetmarch
