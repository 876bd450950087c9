// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Processes/Visits.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace tetmarch
{
namespace
{

// Before any scalar, as in Shaders/gather/extreme.glsl.
constexpr float NothingFound = -3e38f;

// A total order, so that the picture doesn't depend on the order of messages.
bool isBefore(const Visit& a, const Visit& b)
{
  return std::tie(a.Begin, a.End, a.Gathered, a.Error) <
         std::tie(b.Begin, b.End, b.Gathered, b.Error);
}

// "Compositing digital images" (Porter and Duff, 1984), front to back. Its end does not depend on
// the visits behind, and missing visits can only move it back: no product grows by a factor up to
// 1, nor by its rounding. So if some visits hide a depth, all together hide it.
MergedPixel mergeOver(const std::vector<Visit>& visits, float opaque)
{
  MergedPixel merged = emptyPixel(MergeRule::Over);
  std::array<float, 4>& sum = merged.Gathered;
  for (std::size_t i = 0; i < visits.size(); ++i)
  {
    const Visit& visit = visits[i];
    for (int k = 0; k < 3; ++k)
    {
      sum[k] += sum[3] * visit.Gathered[k];
    }
    merged.Error += sum[3] * visit.Error;
    sum[3] *= visit.Gathered[3];
    if (sum[3] < opaque)
    {
      merged.Error += sum[3];
      merged.HiddenFrom = visit.Begin;
      merged.HiddenVisits = static_cast<std::uint32_t>(visits.size() - i - 1);
      break;
    }
  }
  return merged;
}

} // namespace

void VisitLists::finish()
{
  const std::size_t pixels = static_cast<std::size_t>(this->Width) * this->Height;
  this->Starts.assign(pixels + 1, 0);
  for (const std::uint32_t pixel : this->Pixels)
  {
    ++this->Starts[pixel + 1];
  }
  for (std::size_t i = 0; i < pixels; ++i)
  {
    this->Starts[i + 1] += this->Starts[i];
  }
  std::vector<std::uint32_t> next(this->Starts.begin(), this->Starts.end() - 1);
  std::vector<Visit> sorted(this->Added.size());
  for (std::size_t i = 0; i < this->Added.size(); ++i)
  {
    sorted[next[this->Pixels[i]]++] = this->Added[i];
  }
  this->Added.swap(sorted);
  std::vector<std::uint32_t>().swap(this->Pixels);
}

MergedPixel emptyPixel(MergeRule rule)
{
  switch (rule)
  {
    case MergeRule::Over:
      return { { { 0, 0, 0, 1 } }, 0 };
    case MergeRule::Greatest:
      return { { { NothingFound, 0, 0, 0 } }, 0 };
    default:
      return { { { 0, 0, 0, 0 } }, 0 };
  }
}

MergedPixel mergeVisits(std::vector<Visit>& visits, MergeRule rule, float opaque)
{
  std::sort(visits.begin(), visits.end(), isBefore);
  if (rule == MergeRule::Over)
  {
    return mergeOver(visits, opaque);
  }
  MergedPixel merged = emptyPixel(rule);
  for (const Visit& visit : visits)
  {
    for (int k = 0; k < 2; ++k)
    {
      float& value = merged.Gathered[k];
      value =
        rule == MergeRule::Sum ? value + visit.Gathered[k] : std::max(value, visit.Gathered[k]);
    }
  }
  return merged;
}

} // namespace tetmarch
