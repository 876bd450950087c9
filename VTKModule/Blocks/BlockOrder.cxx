// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/BlockOrder.h"

#include <algorithm>
#include <numeric>

namespace tetmarch
{
namespace
{

using Eye = std::array<double, 4>;

// Whether a plane perpendicular to an axis separates `a` from `b` and the eye.
bool isBeyondAPlane(const BlockBox& a, const BlockBox& b, const Eye& eye)
{
  for (int k = 0; k < 3; ++k)
  {
    const double aLow = a[2 * k];
    const double aHigh = a[2 * k + 1];
    const bool eyeBelow = eye[3] != 0 ? eye[k] <= aLow : eye[k] <= 0;
    const bool eyeAbove = eye[3] != 0 ? eye[k] >= aHigh : eye[k] >= 0;
    if ((b[2 * k + 1] <= aLow && eyeBelow) || (b[2 * k] >= aHigh && eyeAbove))
    {
      return true;
    }
  }
  return false;
}

double distanceOf(const BlockBox& box, const Eye& eye)
{
  double distance = 0;
  for (int k = 0; k < 3; ++k)
  {
    const double middle = 0.5 * (box[2 * k] + box[2 * k + 1]);
    const double away = middle - eye[k];
    distance += eye[3] != 0 ? away * away : -middle * eye[k];
  }
  return distance;
}

// Whether b can hide part of a, and a nothing of b.
bool comesBefore(const BlockBox& a, const BlockBox& b, const Eye& eye)
{
  return isBeyondAPlane(a, b, eye) && !isBeyondAPlane(b, a, eye);
}

} // namespace

std::vector<std::size_t> backToFront(const std::vector<BlockBox>& boxes, const Eye& eye)
{
  std::vector<std::size_t> left(boxes.size());
  std::iota(left.begin(), left.end(), std::size_t{ 0 });
  std::stable_sort(left.begin(), left.end(),
    [&](std::size_t a, std::size_t b)
    { return distanceOf(boxes[a], eye) > distanceOf(boxes[b], eye); });
  std::vector<int> waitsFor(boxes.size(), 0); // number of others that come before it
  const auto countWaiting = [&](std::size_t box, int step)
  {
    for (std::size_t other : left)
    {
      waitsFor[other] += comesBefore(boxes[box], boxes[other], eye) ? step : 0;
    }
  };
  for (std::size_t box = 0; box < boxes.size(); ++box)
  {
    countWaiting(box, 1);
  }
  std::vector<std::size_t> order;
  while (!left.empty())
  {
    auto next =
      std::find_if(left.begin(), left.end(), [&](std::size_t box) { return waitsFor[box] == 0; });
    next = next == left.end() ? left.begin() : next; // a cycle
    order.push_back(*next);
    left.erase(next);
    countWaiting(order.back(), -1);
  }
  return order;
}

} // namespace tetmarch
