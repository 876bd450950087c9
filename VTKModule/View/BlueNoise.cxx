// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "View/BlueNoise.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace tetmarch
{
namespace
{

constexpr int Side = BlueNoiseSide;
constexpr int Count = Side * Side;
constexpr int Minority = Count / 10; // of the initial pattern: few enough for an even distribution
constexpr double Sigma = 1.5;

// Points on the torus, and for each position a measure of their density: a sum of Gaussians, in
// integers, which stay exact when points are added and removed.
class PointPattern
{
public:
  PointPattern()
    : Kernel(2 * static_cast<std::size_t>(Count))
    , Energy(Count, 0)
    , Filled(Count, false)
  {
    for (int y = 0; y < Side; ++y)
    {
      for (int x = 0; x < 2 * Side; ++x)
      {
        const double dx = std::min(x % Side, Side - x % Side);
        const double dy = std::min(y, Side - y);
        // If all positions are filled, the sum is 2 pi Sigma^2 of these: below 2^64.
        this->Kernel[y * 2 * Side + x] = static_cast<std::uint64_t>(
          std::ldexp(std::exp(-(dx * dx + dy * dy) / (2 * Sigma * Sigma)), 60));
      }
    }
  }

  bool isFilled(int place) const { return this->Filled[place]; }

  void set(int place, bool filled)
  {
    this->Filled[place] = filled;
    const int px = place % Side;
    const int py = place / Side;
    for (int y = 0; y < Side; ++y)
    {
      // Rows of the kernel are stored twice, so that none has to be wrapped.
      const std::uint64_t* kernel = &this->Kernel[((y - py + Side) % Side) * 2 * Side + Side - px];
      std::uint64_t* energy = &this->Energy[y * Side];
      for (int x = 0; x < Side; ++x)
      {
        energy[x] += filled ? kernel[x] : 0 - kernel[x];
      }
    }
  }

  int tightestCluster() const
  {
    int found = -1;
    for (int i = 0; i < Count; ++i)
    {
      if (this->Filled[i] && (found < 0 || this->Energy[i] > this->Energy[found]))
      {
        found = i;
      }
    }
    return found;
  }

  int largestVoid() const
  {
    int found = -1;
    for (int i = 0; i < Count; ++i)
    {
      if (!this->Filled[i] && (found < 0 || this->Energy[i] < this->Energy[found]))
      {
        found = i;
      }
    }
    return found;
  }

private:
  std::vector<std::uint64_t> Kernel;
  std::vector<std::uint64_t> Energy;
  std::vector<char> Filled;
};

// Random points, moved from the tightest cluster to the largest void until nothing changes.
PointPattern evenPattern()
{
  PointPattern pattern;
  std::mt19937 random(1993); // its raw numbers are portable; distributions aren't
  for (int n = 0; n < Minority;)
  {
    const int place = static_cast<int>(random() % Count);
    if (!pattern.isFilled(place))
    {
      pattern.set(place, true);
      ++n;
    }
  }
  for (;;)
  {
    const int from = pattern.tightestCluster();
    pattern.set(from, false);
    const int to = pattern.largestVoid();
    pattern.set(to, true);
    if (to == from)
    {
      return pattern;
    }
  }
}

std::vector<float> makeTile()
{
  std::vector<float> tile(Count);
  const auto rank = [&](int place, int number)
  { tile[place] = (static_cast<float>(number) + 0.5f) / Count; };
  const PointPattern even = evenPattern();
  PointPattern pattern = even;
  for (int n = Minority; n-- > 0;)
  {
    const int place = pattern.tightestCluster();
    pattern.set(place, false);
    rank(place, n);
  }
  // Beyond half of the positions the tightest cluster of empty ones is filled: on the torus the
  // sums over filled and empty positions add up to a constant, so that this is again the largest
  // void.
  pattern = even;
  for (int n = Minority; n < Count; ++n)
  {
    const int place = pattern.largestVoid();
    pattern.set(place, true);
    rank(place, n);
  }
  return tile;
}

} // namespace

const std::vector<float>& blueNoiseTile()
{
  static const std::vector<float> tile = makeTile();
  return tile;
}

} // namespace tetmarch
