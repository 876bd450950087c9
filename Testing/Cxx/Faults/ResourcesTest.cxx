// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A mesh that doesn't fit in memory is refused with figures, and drawn as soon as it fits.
#include "ErrorScene.h"
#include "ScarceMemory.h"

#include "vtkPointData.h"
#include "vtkPoints.h"

#include <array>
#include <limits>

namespace
{
using namespace tetmarch::testing;

class Resources : public ErrorScene
{
};

TEST_F(Resources, MemoryCap)
{
  auto* mapper = this->Shown.Mapper.Get();
  const vtkTypeInt64 bytes = mapper->GetUploadedBytes(); // of the first frame: all of them
  EXPECT_GT(bytes, 10000);
  this->expectError(
    [&]
    {
      mapper->SetMaxMemoryInBytes(bytes - 1);
      this->Shown.Window->Render();
      EXPECT_EQ(mapper->GetGPUMemoryBytes(), 0);
    },
    [&] { mapper->SetMaxMemoryInBytes(bytes); },
    { std::to_string(bytes) + " bytes", std::to_string(bytes - 1), "MaxMemoryInBytes" });
  EXPECT_EQ(mapper->GetMeshBuilds(), 1);
  mapper->SetMaxMemoryInBytes(0);
  this->expectSound();
}

TEST_F(Resources, MemoryCapBeforeTheMeshIsMade)
{
  vtkNew<vtkTetMarchVolumeMapper> mapper;
  const ErrorWatch watch(mapper);
  mapper->SetInputData(soundGrid());
  mapper->SetMaxMemoryInBytes(16 * 384 - 1);
  this->Shown.Volume->SetMapper(mapper);
  this->expectEmpty();
  this->expectEmpty();
  ASSERT_EQ(watch.Errors.size(), 1u);
  EXPECT_NE(watch.Errors[0].find("at least 6144 bytes"), std::string::npos) << watch.Errors[0];
  EXPECT_EQ(mapper->GetMeshBuilds(), 0);
  EXPECT_EQ(mapper->GetUploadedBytes(), 0);
  EXPECT_EQ(mapper->GetGPUMemoryBytes(), 0);
  // The next bound needs the mesh, but nothing on the GPU.
  mapper->SetMaxMemoryInBytes(16 * 384);
  this->expectEmpty();
  ASSERT_EQ(watch.Errors.size(), 2u);
  EXPECT_EQ(watch.Errors[1].find("at least"), std::string::npos) << watch.Errors[1];
  EXPECT_EQ(mapper->GetMeshBuilds(), 1);
  EXPECT_EQ(mapper->GetUploadedBytes(), 0);
  mapper->SetMaxMemoryInBytes(0);
  this->expectSound();
  EXPECT_EQ(mapper->GetMeshBuilds(), 1);
  this->Shown.Volume->SetMapper(this->Shown.Mapper);
}

TEST_F(Resources, AMeshThatFailedIsNotMadeAgain)
{
  auto* mapper = this->Shown.Mapper.Get();
  const ErrorWatch watch(mapper);
  const Grid grid = soundGrid();
  const std::array<double, 3> good = [&]
  {
    std::array<double, 3> point;
    grid->GetPoints()->GetPoint(33, point.data());
    return point;
  }();
  grid->GetPoints()->SetPoint(33, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  this->show(grid);
  for (int i = 0; i < 3; ++i)
  {
    this->expectEmpty();
    this->Shown.camera()->Roll(360.0); // a camera that moves
    EXPECT_EQ(mapper->GetMeshBuilds(), 2);
  }
  EXPECT_EQ(watch.Errors.size(), 1u);
  grid->GetPoints()->SetPoint(33, good.data());
  grid->Modified();
  this->expectSound();
  EXPECT_EQ(mapper->GetMeshBuilds(), 3);
  EXPECT_EQ(watch.Errors.size(), 1u);
}

TEST_F(Resources, NoMemoryForTheMesh)
{
  // More than a picture needs, which the GL takes from elsewhere.
  const Grid grid = jitteredLattice(16, 0.15, 1, sineField());
  auto* mapper = this->Shown.Mapper.Get();
  const ErrorWatch watch(mapper);
  this->show(grid);
  {
    const ScarceMemory scarce(200000);
    this->expectEmpty();
    this->expectEmpty();
    EXPECT_EQ(ScarceMemory::failures(), 1);
  }
  ASSERT_EQ(watch.Errors.size(), 1u);
  EXPECT_NE(watch.Errors[0].find("too little memory for preparing the mesh"), std::string::npos);
  EXPECT_NE(watch.Errors[0].find("Modified()"), std::string::npos);
  EXPECT_EQ(mapper->GetMeshBuilds(), 2);
  grid->Modified();
  EXPECT_GT(compare(this->frame(), this->Empty).Max, 0.1);
  EXPECT_EQ(watch.Errors.size(), 1u);
}

TEST_F(Resources, NoMemoryForScalarsTablesAndCounters)
{
  auto* mapper = this->Shown.Mapper.Get();
  const ErrorWatch watch(mapper);
  const struct
  {
    const char* Purpose;
    std::size_t Bytes;
    std::function<void()> Touch;
  } cases[] = {
    { "the scalars", 125 * 8,
      [this] { this->Shown.Data->GetPointData()->GetScalars()->Modified(); } },
    { "the tables", 30000, [this] { this->Shown.property()->GetScalarOpacity()->Modified(); } },
    { "drawing", 16 * Side * Side, [] {} },
  };
  std::size_t errors = 0;
  for (const auto& c : cases)
  {
    c.Touch();
    {
      const ScarceMemory scarce(c.Bytes, 0);
      this->Shown.Window->Render();
      EXPECT_EQ(ScarceMemory::failures(), 1) << c.Purpose;
    }
    EXPECT_EQ(compare(this->Shown.frame(), this->Empty).Max, 0.0) << c.Purpose;
    ASSERT_EQ(watch.Errors.size(), ++errors) << c.Purpose;
    EXPECT_NE(watch.Errors.back().find(std::string("too little memory for ") + c.Purpose),
      std::string::npos)
      << watch.Errors.back();
    this->expectSound();
    EXPECT_EQ(watch.Errors.size(), errors);
  }
  EXPECT_EQ(mapper->GetMeshBuilds(), 1);
}
} // namespace
