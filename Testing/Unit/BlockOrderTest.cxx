// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Blocks are drawn before all that hide something of them, by the points in which rays meet them.
#include "Blocks/BlockOrder.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace
{
using tetmarch::BlockBox;

class Numbers
{
public:
  explicit Numbers(unsigned int seed)
    : Engine(seed)
  {
  }
  double between(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->Engine()) / 4294967296.0);
  }
  int below(int count) { return static_cast<int>(this->Engine() % static_cast<unsigned>(count)); }

private:
  std::mt19937 Engine;
};

// A box cut again and again, each time across an axis: the parts share faces and overlap nowhere.
std::vector<BlockBox> cutBox(Numbers& numbers, int cuts)
{
  std::vector<BlockBox> boxes{ { { 0, 1, 0, 1, 0, 1 } } };
  for (int i = 0; i < cuts; ++i)
  {
    const auto cut = static_cast<std::size_t>(numbers.below(static_cast<int>(boxes.size())));
    const int axis = numbers.below(3);
    BlockBox high = boxes[cut];
    const double place = numbers.between(high[2 * axis], high[2 * axis + 1]);
    boxes[cut][2 * axis + 1] = place;
    high[2 * axis] = place;
    boxes.push_back(high);
  }
  return boxes;
}

// Where a ray is in the box: depths, in units of its direction; empty if the first is not less.
std::array<double, 2> chordOf(
  const BlockBox& box, const std::array<double, 3>& origin, const std::array<double, 3>& direction)
{
  std::array<double, 2> chord{ { 0, 1e30 } };
  for (int k = 0; k < 3; ++k)
  {
    const double a = (box[2 * k] - origin[k]) / direction[k];
    const double b = (box[2 * k + 1] - origin[k]) / direction[k];
    chord[0] = std::max(chord[0], std::min(a, b));
    chord[1] = std::min(chord[1], std::max(a, b));
  }
  return chord;
}

// Rays that meet the box drawn later behind the one drawn earlier.
int countWrong(const std::vector<BlockBox>& boxes, const std::vector<std::size_t>& order,
  const std::array<double, 4>& eye, Numbers& numbers)
{
  int wrong = 0;
  for (int ray = 0; ray < 200; ++ray)
  {
    const std::array<double, 3> target{ { numbers.between(0, 1), numbers.between(0, 1),
      numbers.between(0, 1) } };
    std::array<double, 3> origin{};
    std::array<double, 3> direction{};
    for (int k = 0; k < 3; ++k)
    {
      origin[k] = eye[3] != 0 ? eye[k] : target[k] + 10 * eye[k];
      direction[k] = target[k] - origin[k];
    }
    double last = 1e30;
    for (std::size_t i : order)
    {
      const std::array<double, 2> chord = chordOf(boxes[i], origin, direction);
      if (chord[1] - chord[0] > 1e-9)
      {
        wrong += chord[0] > last ? 1 : 0;
        last = chord[0];
      }
    }
  }
  return wrong;
}

TEST(BlockOrder, RaysMeetLaterBlocksBeforeEarlierOnes)
{
  Numbers numbers(7);
  for (int scene = 0; scene < 60; ++scene)
  {
    const std::vector<BlockBox> boxes = cutBox(numbers, 1 + numbers.below(20));
    std::array<double, 4> eye{ { numbers.between(-3, 3), numbers.between(-3, 3),
      numbers.between(-3, 3), scene % 2 ? 1.0 : 0.0 } };
    EXPECT_EQ(countWrong(boxes, tetmarch::backToFront(boxes, eye), eye, numbers), 0) << scene;
  }
}

TEST(BlockOrder, AnEyeAmongTheBlocks)
{
  Numbers numbers(11);
  for (int scene = 0; scene < 40; ++scene)
  {
    const std::vector<BlockBox> boxes = cutBox(numbers, 12);
    const std::array<double, 4> eye{ { numbers.between(0, 1), numbers.between(0, 1),
      numbers.between(0, 1), 1 } };
    EXPECT_EQ(countWrong(boxes, tetmarch::backToFront(boxes, eye), eye, numbers), 0) << scene;
  }
}

TEST(BlockOrder, DistancesOfMiddlesAloneAreNotEnough)
{
  // A long box behind a small one whose middle is farther from the eye.
  const std::vector<BlockBox> boxes{ { { 0, 10, 1, 2, 0, 1 } }, { { 9, 10, 0, 1, 0, 1 } } };
  const std::array<double, 4> eye{ { 5, -1, 0.5, 1 } };
  EXPECT_EQ(tetmarch::backToFront(boxes, eye), (std::vector<std::size_t>{ 0, 1 }));
}

TEST(BlockOrder, OfOverlappingBlocksTheFartherMiddleComesFirst)
{
  const std::vector<BlockBox> boxes{ { { 0, 2, 0, 2, 0, 2 } }, { { 1, 3, 1, 3, 1, 3 } } };
  EXPECT_EQ(tetmarch::backToFront(boxes, { { 9, 9, 9, 1 } }), (std::vector<std::size_t>{ 0, 1 }));
  EXPECT_EQ(
    tetmarch::backToFront(boxes, { { -9, -9, -9, 1 } }), (std::vector<std::size_t>{ 1, 0 }));
  EXPECT_EQ(tetmarch::backToFront(boxes, { { 1, 1, 1, 0 } }), (std::vector<std::size_t>{ 0, 1 }));
}

TEST(BlockOrder, ACircleOfBlocksIsCutOpen)
{
  // Three bars, each of which hides an end of the next, seen from (1, 1, 1).
  const std::vector<BlockBox> boxes{ { { 0, 3, 0, 1, 1, 2 } }, { { 2, 3, 0, 3, 0, 1 } },
    { { 1, 2, 2, 3, 0, 3 } } };
  std::vector<std::size_t> order = tetmarch::backToFront(boxes, { { 1, 1, 1, 0 } });
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, (std::vector<std::size_t>{ 0, 1, 2 }));
}
} // namespace
