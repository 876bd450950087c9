// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a hardware selector reads in each of its passes, without a window.
#include "Picking/SelectedCells.h"

#include "PassSelector.h"

#include "vtkDataObject.h"
#include "vtkNew.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using tetmarch::testing::PassSelector;

// Clip coordinates are those of the normalised frame.
View identity()
{
  View view;
  for (int k = 0; k < 4; ++k)
  {
    view.NormalizedToClip[5 * k] = 1;
  }
  return view;
}

PickedPoint hit(vtkIdType cell, double z)
{
  PickedPoint point;
  point.Hit = true;
  point.Cell = cell;
  point.Position = { { 0.1, 0.2, z } };
  return point;
}

class SelectedCells : public ::testing::Test
{
protected:
  std::vector<float> texels(int pass, const std::vector<PickedPoint>& points)
  {
    this->Selector->enter(pass);
    return selectionTexels(this->Selector, points, this->Origins, identity());
  }
  // The number that a colour means.
  static vtkIdType numberOf(const std::vector<float>& texels, std::size_t point)
  {
    vtkIdType number = 0;
    for (int k = 2; k >= 0; --k)
    {
      number = 256 * number + std::lround(255 * texels[4 * point + k]);
    }
    return number;
  }

  vtkNew<PassSelector> Selector;
  CellOrigins Origins;
};

TEST_F(SelectedCells, NumbersOfCellsComeInTwoPasses)
{
  const vtkIdType cell = (vtkIdType(3) << 24) + 70000;
  const std::vector<PickedPoint> points{ hit(cell, 0.0), hit(5, 0.5), {} };
  const auto low = this->texels(vtkHardwareSelector::CELL_ID_LOW24, points);
  const auto high = this->texels(vtkHardwareSelector::CELL_ID_HIGH24, points);
  EXPECT_EQ(numberOf(low, 0), 70000);
  EXPECT_EQ(numberOf(high, 0), 3);
  EXPECT_EQ(numberOf(low, 1), 5);
  EXPECT_EQ(numberOf(high, 1), 0);
  EXPECT_EQ(this->Selector->greatestCell(), cell);
  EXPECT_EQ(this->Selector->Begun, 2);
  EXPECT_EQ(this->Selector->Ended, 2);
}

TEST_F(SelectedCells, DepthsAreThoseOfTheWindow)
{
  const auto found = this->texels(vtkHardwareSelector::CELL_ID_LOW24,
    { hit(1, -0.5), hit(1, 0.5), hit(1, 1.0), hit(1, -3.0), {} });
  EXPECT_FLOAT_EQ(found[3], 0.25f);
  EXPECT_FLOAT_EQ(found[7], 0.75f);
  EXPECT_LT(found[11], 1.0f); // what is hit is nearer than what is not
  EXPECT_EQ(found[15], 0.0f);
  EXPECT_EQ(found[19], 1.0f);
}

TEST_F(SelectedCells, OfBlocksTheirNumbersAndTheirOwnCells)
{
  this->Origins.add(2, 10);
  this->Origins.add(7, 10);
  const std::vector<PickedPoint> points{ hit(4, 0.0), hit(13, 0.0) };
  const auto blocks = this->texels(vtkHardwareSelector::COMPOSITE_INDEX_PASS, points);
  EXPECT_EQ(numberOf(blocks, 0), 2);
  EXPECT_EQ(numberOf(blocks, 1), 7);
  const auto cells = this->texels(vtkHardwareSelector::CELL_ID_LOW24, points);
  EXPECT_EQ(numberOf(cells, 0), 4);
  EXPECT_EQ(numberOf(cells, 1), 3);
}

TEST_F(SelectedCells, OtherPassesHaveTheColorOfTheProp)
{
  this->Selector->SetPropColorValue(0.25f, 0.5f, 0.75f);
  const auto found = this->texels(vtkHardwareSelector::ACTOR_PASS, { hit(4, 0.0) });
  EXPECT_EQ((std::array<float, 3>{ { found[0], found[1], found[2] } }),
    (std::array<float, 3>{ { 0.25f, 0.5f, 0.75f } }));
}

TEST_F(SelectedCells, PointsAreNotAskedFor)
{
  this->Selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  for (const int pass :
    { vtkHardwareSelector::ACTOR_PASS, vtkHardwareSelector::COMPOSITE_INDEX_PASS,
      vtkHardwareSelector::CELL_ID_LOW24, vtkHardwareSelector::CELL_ID_HIGH24 })
  {
    this->Selector->enter(pass);
    EXPECT_TRUE(asksForCells(this->Selector)) << pass;
  }
  for (const int pass :
    { vtkHardwareSelector::POINT_ID_LOW24, vtkHardwareSelector::POINT_ID_HIGH24 })
  {
    this->Selector->enter(pass);
    EXPECT_FALSE(asksForCells(this->Selector)) << pass;
  }
  this->Selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  this->Selector->enter(vtkHardwareSelector::CELL_ID_LOW24);
  EXPECT_FALSE(asksForCells(this->Selector));
}
} // namespace
