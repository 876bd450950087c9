// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The normalised frame of a volume: its points in coordinates of the data, and boxes that have
// none.
#include "Geometry/VolumeFrame.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;

TEST(VolumeFrame, IsThatOfTheBoundingBox)
{
  VolumeFrame frame;
  ASSERT_EQ(findFrame({ { { 1, 2, 3 } }, { { 3, 2, 3 } }, { { 1, 6, 7 } } }, frame), "");
  EXPECT_EQ(frame.Center, (Vector3{ { 2, 4, 5 } }));
  EXPECT_DOUBLE_EQ(frame.Radius, 3.0);
  EXPECT_DOUBLE_EQ(frame.HalfExtent[0], 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(frame.HalfExtent[2], 2.0 / 3.0);
}

TEST(VolumeFrame, PointsAndMatrixSayTheSame)
{
  const VolumeFrame frame{ { { 10, -20, 30 } }, 4, {} };
  const Vector3 point{ { 0.5, -0.25, 1 } };
  const Vector3 data = frame.toData(point);
  EXPECT_EQ(data, (Vector3{ { 12, -21, 34 } }));
  const auto m = frame.matrixToData();
  for (int r = 0; r < 3; ++r)
  {
    EXPECT_DOUBLE_EQ(
      m[4 * r] * point[0] + m[4 * r + 1] * point[1] + m[4 * r + 2] * point[2] + m[4 * r + 3],
      data[r]);
  }
  EXPECT_EQ(m[15], 1.0);
}

TEST(VolumeFrame, BoxesTooSmallForDoubleAreRefused)
{
  VolumeFrame frame;
  EXPECT_NE(findFrame({ { { 0, 0, 0 } }, { { 1e-120, 0, 0 } } }, frame), "");
  EXPECT_EQ(findFrame({ { { 0, 0, 0 } }, { { 1e-90, 0, 0 } } }, frame), "");
  EXPECT_DOUBLE_EQ(frame.Radius, 5e-91);
}

TEST(VolumeFrame, OnePointHasTheUnitOfTheData)
{
  VolumeFrame frame;
  EXPECT_EQ(findFrame({ { { 1, 2, 3 } }, { { 1, 2, 3 } } }, frame), "");
  EXPECT_EQ(frame.Radius, 1.0);
  EXPECT_EQ(frame.Center, (Vector3{ { 1, 2, 3 } }));
  EXPECT_EQ(frame.HalfExtent, Vector3{});
}
} // namespace
