// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What processes tell each other arrives, whole and where it belongs.
#include "ThreadGroup.h"

#include "Processes/SharedPicture.h"

#include "vtkMultiProcessController.h"

#include <gtest/gtest.h>
#include <random>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr std::array<int, 7> Sizes{ { 1, 2, 3, 5, 7, 8, 16 } };

// The same in all processes.
Bytes messageOf(int from, int to)
{
  std::mt19937 random(static_cast<unsigned int>(100 * from + to));
  Bytes message(random() % 5000);
  for (unsigned char& byte : message)
  {
    byte = static_cast<unsigned char>(random());
  }
  return (from + to) % 5 == 4 ? Bytes() : message;
}

TEST(Group, ExchangeBringsEachMessageToItsProcess)
{
  for (const int size : Sizes)
  {
    runTogether(size,
      [&](Group& group)
      {
        std::vector<Bytes> outgoing;
        for (int p = 0; p < size; ++p)
        {
          outgoing.push_back(messageOf(group.rank(), p));
        }
        const std::vector<Bytes> incoming = group.exchange(outgoing);
        ASSERT_EQ(incoming.size(), static_cast<std::size_t>(size));
        for (int p = 0; p < size; ++p)
        {
          EXPECT_EQ(incoming[p], messageOf(p, group.rank())) << p << " to " << group.rank();
        }
      });
  }
}

TEST(Group, AllAreToldTheSame)
{
  for (const int size : Sizes)
  {
    runTogether(size,
      [&](Group& group)
      {
        const std::vector<Bytes> said = group.tellAll(messageOf(group.rank(), 3));
        for (int p = 0; p < size; ++p)
        {
          EXPECT_EQ(said[p], messageOf(p, 3));
        }
      });
  }
}

TEST(Group, TheLeastOfEachNumberIsKept)
{
  for (const int size : Sizes)
  {
    runTogether(size,
      [&](Group& group)
      {
        std::vector<float> values;
        for (int i = 0; i < 100; ++i)
        {
          values.push_back(static_cast<float>((i * 7 + group.rank() * 13) % 17));
        }
        group.keepLeast(values);
        for (int i = 0; i < 100; ++i)
        {
          float least = 17;
          for (int p = 0; p < size; ++p)
          {
            least = std::min(least, static_cast<float>((i * 7 + p * 13) % 17));
          }
          EXPECT_EQ(values[i], least);
        }
      });
  }
}

TEST(Group, SentBytesAreCounted)
{
  runTogether(2,
    [](Group& group)
    {
      EXPECT_EQ(group.sentBytes(), 0u);
      std::vector<Bytes> outgoing(2);
      outgoing[1 - group.rank()].resize(1000);
      outgoing[group.rank()].resize(500); // which goes nowhere
      group.exchange(outgoing);
      EXPECT_EQ(group.sentBytes(), 1008u); // with the size
    });
}

// What a damaged message says about its length takes no memory.
TEST(Group, ALengthThatLies)
{
  for (const vtkTypeInt64 lie : { vtkTypeInt64(-1), vtkTypeInt64(1) << 60 })
  {
    runControllers(2,
      [lie](vtkMultiProcessController* controller)
      {
        constexpr int tag = 20190; // of a group's messages
        if (controller->GetLocalProcessId() == 0)
        {
          Group group(controller);
          EXPECT_THROW(group.exchange({ {}, {} }), GroupFailure) << lie;
        }
        else
        {
          controller->Send(&lie, 1, 0, tag);
          const std::vector<char> tooLong(std::size_t(1) << 27);
          controller->Send(tooLong.data(), 1 << 27, 0, tag);
        }
      });
  }
}

TEST(Group, LengthsThatLieToAll)
{
  for (const vtkIdType lie : { vtkIdType(-1), vtkIdType(1) << 40 })
  {
    runControllers(2,
      [lie](vtkMultiProcessController* controller)
      {
        std::vector<vtkIdType> counts(2);
        if (controller->GetLocalProcessId() == 0)
        {
          Group group(controller);
          EXPECT_THROW(group.tellAll(Bytes{ 1 }), GroupFailure) << lie;
        }
        else
        {
          controller->AllGather(&lie, counts.data(), 1);
        }
      });
  }
}

TEST(Group, AGroupWithoutControllerHasOneProcess)
{
  Group group;
  EXPECT_EQ(group.size(), 1);
  EXPECT_EQ(group.rank(), 0);
  EXPECT_EQ(group.tellAll(Bytes{ 1, 2 }), (std::vector<Bytes>{ { 1, 2 } }));
  EXPECT_EQ(group.exchange({ { 3 } }), (std::vector<Bytes>{ { 3 } }));
  EXPECT_EQ(sharedError(group, "wrong"), "wrong");
  EXPECT_EQ(group.sentBytes(), 0u);
}

TEST(Group, TheFirstErrorIsThatOfAll)
{
  for (const int size : Sizes)
  {
    runTogether(size,
      [&](Group& group)
      {
        EXPECT_EQ(sharedError(group, ""), "");
        const int last = size - 1;
        const std::string error = sharedError(group, group.rank() == last ? "no memory." : "");
        EXPECT_EQ(
          error, size > 1 ? "Process " + std::to_string(last) + ": no memory." : "no memory.");
        EXPECT_TRUE(anyOf(group, group.rank() == last));
        EXPECT_FALSE(anyOf(group, false));
      });
  }
}

TEST(Group, AllStopIfOneDoes)
{
  runTogether(3,
    [](Group& group)
    {
      PartStatus own;
      own.Width = 20;
      own.Height = 10;
      EXPECT_FALSE(agreeOn(group, own).Stopped);
      EXPECT_EQ(agreeOn(group, own).Error, "");
      own.Stopped = group.rank() == 1;
      EXPECT_TRUE(agreeOn(group, own).Stopped);
    });
}

TEST(Group, PicturesOfOneSizeAreAskedFor)
{
  runTogether(3,
    [](Group& group)
    {
      PartStatus own;
      own.Width = group.rank() == 2 ? 30 : 20;
      own.Height = 10;
      const std::string error = agreeOn(group, own).Error;
      EXPECT_NE(error.find("20 x 10"), std::string::npos) << error;
      EXPECT_NE(error.find("process 2 has 30 x 10"), std::string::npos) << error;
    });
}

} // namespace
