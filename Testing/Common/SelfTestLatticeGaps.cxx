// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the ground truth of images leaves out: hidden cells and points, and what is not a number.
#include "LatticeImages.h"
#include "SelfTestPlacedRay.h"

#include "vtkDataSetAttributes.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

// Of the cube of 5^3 cells: how far from 0 to 1 along each axis nothing is drawn.
struct Gap
{
  double Low;
  double High;
};

void expectGap(vtkImageData* image, LatticeValues values, const Gap& gap)
{
  std::mt19937 generator(24);
  const LatticeTruth whole(imageOf(linearField(), unitCube(5)), spiky(), values);
  const LatticeTruth truth(image, spiky(), values);
  for (int i = 0; i < 200; ++i)
  {
    const PlacedRay ray = placedRay(image, generator);
    const double missing = boxChord(
      ray.Origin, ray.Direction, { gap.Low, gap.Low, gap.Low }, { gap.High, gap.High, gap.High });
    ASSERT_NEAR(truth.pathLength(ray.Origin, ray.Direction),
      whole.pathLength(ray.Origin, ray.Direction) - missing, 1e-13)
      << static_cast<int>(values);
  }
}

// In the order of AllValues. Cell 62 is the one in the middle, point 86 its lowest.
TEST(LatticeTruth, HiddenCellsAndPointsAreNotDrawn)
{
  const auto middle = [](vtkIdType id) { return id == 62; };
  const auto lowest = [](vtkIdType id) { return id == 86; };
  const Gap ofCell[] = { { 0.4, 0.6 }, { 0.0, 0.0 }, { 0.3, 0.7 }, { 0.4, 0.6 } };
  const Gap ofPoint[] = { { 0.2, 0.6 }, { 0.3, 0.5 }, { 0.1, 0.7 }, { 0.2, 0.6 } };
  const Gap ofAllAround[] = { { 0.2, 0.6 }, { 0.3, 0.5 }, { 0.1, 0.7 }, { 0.2, 0.6 } };
  const auto around = [](vtkIdType id)
  {
    const auto isNear = [](vtkIdType i) { return i == 1 || i == 2; };
    return isNear(id % 5) && isNear(id / 5 % 5) && isNear(id / 25);
  };
  for (const int bit : { vtkDataSetAttributes::HIDDENCELL, vtkDataSetAttributes::DUPLICATECELL,
         vtkDataSetAttributes::REFINEDCELL })
  {
    const auto blanked = imageOf(linearField(), unitCube(5));
    markCells(blanked, bit, middle);
    const auto more = imageOf(linearField(), unitCube(5));
    markCells(more, bit, around);
    for (int i = 0; i < 4; ++i)
    {
      expectGap(blanked, AllValues[i], ofCell[i]);
      expectGap(more, AllValues[i], ofAllAround[i]);
    }
  }
  const auto pointless = imageOf(linearField(), unitCube(5));
  markPoints(pointless, vtkDataSetAttributes::HIDDENPOINT, lowest);
  const auto doubled = imageOf(linearField(), unitCube(5));
  markPoints(doubled, vtkDataSetAttributes::DUPLICATEPOINT, lowest);
  for (int i = 0; i < 4; ++i)
  {
    expectGap(pointless, AllValues[i], ofPoint[i]);
    expectGap(doubled, AllValues[i], { 0.0, 0.0 });
  }
}

TEST(LatticeTruth, WhatIsNotANumberIsNotDrawn)
{
  const auto spoilt = imageOf(linearField(), unitCube(5));
  spoilScalars(
    spoilt, [](vtkIdType id) { return id == 86; }, [](vtkIdType id) { return id == 62; });
  const Gap gaps[] = { { 0.2, 0.6 }, { 0.3, 0.5 }, { 0.3, 0.7 }, { 0.4, 0.6 } };
  for (int i = 0; i < 4; ++i)
  {
    expectGap(spoilt, AllValues[i], gaps[i]);
  }
}
} // namespace
