// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Statistics of values over the pixels of a picture.
#ifndef TetMarchDiagnosticsDistribution_h
#define TetMarchDiagnosticsDistribution_h

#include <algorithm>
#include <cmath>
#include <vector>

namespace tetmarch
{

class Distribution
{
public:
  Distribution() = default;
  explicit Distribution(std::vector<float> values)
    : Sorted(std::move(values))
  {
    std::sort(this->Sorted.begin(), this->Sorted.end());
  }

  std::size_t size() const { return this->Sorted.size(); }
  /** These return 0 if there are no values. */
  double minimum() const { return this->Sorted.empty() ? 0.0 : double(this->Sorted.front()); }
  double maximum() const { return this->Sorted.empty() ? 0.0 : double(this->Sorted.back()); }
  double mean() const
  {
    double sum = 0;
    for (const float v : this->Sorted)
    {
      sum += double(v);
    }
    return this->Sorted.empty() ? 0.0 : sum / static_cast<double>(this->Sorted.size());
  }
  double rootMeanSquare() const
  {
    double sum = 0;
    for (const float v : this->Sorted)
    {
      sum += double(v) * double(v);
    }
    return this->Sorted.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(this->Sorted.size()));
  }
  /** The smallest value that this percentage of values doesn't exceed (nearest rank). */
  double percentile(double percent) const
  {
    if (this->Sorted.empty())
    {
      return 0.0;
    }
    const double rank = std::ceil(percent / 100.0 * static_cast<double>(this->Sorted.size()));
    const double last = static_cast<double>(this->Sorted.size());
    return double(this->Sorted[static_cast<std::size_t>(std::min(std::max(rank, 1.0), last)) - 1]);
  }

private:
  std::vector<float> Sorted;
};

} // namespace tetmarch

#endif
