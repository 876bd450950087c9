// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which passes of a selection find the points of an earlier one, without a window.
#include "Picking/SelectionPoints.h"

#include "PassSelector.h"

#include "vtkCommand.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>
#include <memory>

namespace
{
using namespace tetmarch;
using tetmarch::testing::PassSelector;

class KeptPoints : public ::testing::Test
{
protected:
  KeptPoints()
  {
    this->Selector->enter(vtkHardwareSelector::ACTOR_PASS);
    EXPECT_FALSE(this->found({ 1, 2 }));
    this->Points->keep(this->Selector, { 1, 2 }, std::vector<PickedPoint>(3));
    this->Selector->enter(vtkHardwareSelector::CELL_ID_LOW24);
  }
  bool found(const Fingerprint& madeFrom) const
  {
    return this->Points->find(this->Selector, madeFrom) != nullptr;
  }

  vtkSmartPointer<PassSelector> Selector = vtkSmartPointer<PassSelector>::New();
  std::unique_ptr<SelectionPoints> Points = std::make_unique<SelectionPoints>();
};

TEST_F(KeptPoints, AreFoundByLaterPassesOfTheSame)
{
  ASSERT_TRUE(this->found({ 1, 2 }));
  EXPECT_EQ(this->Points->find(this->Selector, { 1, 2 })->size(), 3u);
  EXPECT_FALSE(this->found({ 1, 3 }));
  EXPECT_EQ(this->Points->find(vtkSmartPointer<PassSelector>::New(), { 1, 2 }), nullptr);
  this->Points->keep(this->Selector, { 1, 3 }, {});
  EXPECT_FALSE(this->found({ 1, 2 }));
  EXPECT_TRUE(this->found({ 1, 3 }));
}

// Also if no event has ended the one before.
TEST_F(KeptPoints, AreNotFoundByTheFirstPassOfAnother)
{
  this->Selector->enter(vtkHardwareSelector::ACTOR_PASS);
  EXPECT_FALSE(this->found({ 1, 2 }));
}

TEST_F(KeptPoints, AreFreedAtTheEnd)
{
  ASSERT_TRUE(this->Selector->HasObserver(vtkCommand::EndEvent));
  this->Selector->InvokeEvent(vtkCommand::EndEvent);
  EXPECT_FALSE(this->found({ 1, 2 }));
  EXPECT_FALSE(this->Selector->HasObserver(vtkCommand::EndEvent));
}

TEST_F(KeptPoints, MayEndBeforeTheSelectorOrAfterIt)
{
  this->Points.reset();
  EXPECT_FALSE(this->Selector->HasObserver(vtkCommand::EndEvent));
  this->Points = std::make_unique<SelectionPoints>();
  this->Points->keep(this->Selector, { 1, 2 }, std::vector<PickedPoint>(3));
  this->Selector = nullptr;
  this->Points->clear();
}
} // namespace
