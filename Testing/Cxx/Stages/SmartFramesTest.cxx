// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What vtkSmartVolumeMapper does about a frame, ours does, too: events, times, fewer rays, memory.
#include "Observer.h"
#include "ScarceTime.h"
#include "SmartScene.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

class SmartFrames : public testing::Test
{
protected:
  SmartScene Shown{ imageOf(sineField(), unitCube(20)) };
};

TEST_F(SmartFrames, EventsAndTimesOfAFrame)
{
  int begins = 0;
  int ends = 0;
  const Observer begun(
    this->Shown.Mapper, vtkCommand::VolumeMapperRenderStartEvent, [&] { ++begins; });
  const Observer ended(this->Shown.Mapper, vtkCommand::VolumeMapperRenderEndEvent,
    [&]
    {
      EXPECT_EQ(++ends, begins);
      EXPECT_GT(this->Shown.Mapper->GetTimeToDraw(), 0.0);
    });
  this->Shown.frame();
  this->Shown.frame();
  EXPECT_EQ(ends, 2);
}

TEST_F(SmartFrames, RaysAreFewerInInteractionOnly)
{
  vtkTetMarchSmartVolumeMapper* mapper = this->Shown.Mapper;
  const auto distanceAt = [&](double updateRate)
  {
    this->Shown.Window->SetDesiredUpdateRate(updateRate);
    this->Shown.frame();
    return mapper->GetUsedImageSampleDistance();
  };
  this->Shown.frame(); // whose time is known then
  EXPECT_EQ(distanceAt(0.001), 1.0);
  EXPECT_GT(distanceAt(1e5), 1.0);
  mapper->SetInteractiveUpdateRate(1e6);
  EXPECT_EQ(distanceAt(1e5), 1.0);
  mapper->InteractiveAdjustSampleDistancesOff();
  EXPECT_GT(distanceAt(1e5), 1.0);
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetImageSampleDistance(3.0);
  EXPECT_EQ(distanceAt(1e5), 3.0);
  EXPECT_EQ(distanceAt(0.001), 3.0);
}

// Whatever VTK allocates: by default a smart mapper takes every frame for interactive.
TEST_F(SmartFrames, AllRaysAtRestHoweverLongTheyTake)
{
  vtkTetMarchSmartVolumeMapper* mapper = this->Shown.Mapper;
  makeTimeScarce(this->Shown.Renderer);
  for (const bool adjusts : { true, false })
  {
    mapper->SetInteractiveAdjustSampleDistances(adjusts);
    for (const double updateRate : { 0.0001, 0.002, 5.0 })
    {
      this->Shown.Window->SetDesiredUpdateRate(updateRate);
      this->Shown.frame();
      this->Shown.frame(); // when the time of one is known
      EXPECT_EQ(mapper->GetUsedImageSampleDistance(), updateRate < 1.0 ? 1.0 : 10.0);
    }
  }
}

// The fraction is one of the bytes.
TEST_F(SmartFrames, MemoryIsLimitedToTheFraction)
{
  vtkTetMarchSmartVolumeMapper* mapper = this->Shown.Mapper;
  const Image sound = this->Shown.frame();
  mapper->SetMaxMemoryInBytes(2 * mapper->GetGPUMemoryBytes());
  mapper->SetMaxMemoryFraction(1.0f);
  EXPECT_EQ(compare(this->Shown.frame(), sound).Max, 0.0);
  mapper->AddObserver(vtkCommand::ErrorEvent, vtkNew<vtkCallbackCommand>().Get());
  mapper->SetMaxMemoryFraction(0.1f);
  EXPECT_GT(compare(this->Shown.frame(), sound).Max, 0.1);
  mapper->SetMaxMemoryFraction(1.0f);
  EXPECT_EQ(compare(this->Shown.frame(), sound).Max, 0.0);
}
} // namespace
