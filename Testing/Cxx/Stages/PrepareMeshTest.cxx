// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Work that is done beside frames: preparing a mesh ahead, in another thread, and stopping that or
// the ground truth.
#include "ErrorWatch.h"
#include "Scene.h"

#include "vtkCallbackCommand.h"
#include "vtkFloatArray.h"

#include <gtest/gtest.h>
#include <thread>

namespace
{
using namespace tetmarch::testing;
using Mapper = vtkTetMarchVolumeMapper;

// Stops a mapper's work at its first report, and counts reports.
class Stop
{
public:
  explicit Stop(Mapper* mapper, bool stops = true)
    : Watched(mapper)
    , Stops(stops)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<Stop*>(self)->note(); });
    this->Tag = mapper->AddObserver(vtkCommand::ProgressEvent, this->Command);
  }
  ~Stop() { this->Watched->RemoveObserver(this->Tag); }
  Stop(const Stop&) = delete;
  Stop& operator=(const Stop&) = delete;

  int Reports = 0;

private:
  void note()
  {
    ++this->Reports;
    if (this->Stops)
    {
      this->Watched->SetAbortExecute(1);
    }
  }

  Mapper* Watched;
  bool Stops;
  vtkNew<vtkCallbackCommand> Command;
  unsigned long Tag = 0;
};

class PrepareMesh : public testing::Test
{
protected:
  Mapper* mapper() { return this->Shown.Mapper; }

  Scene Shown{ jitteredLattice(8, 0.15, 5, sineField()) };
};

TEST_F(PrepareMesh, InAnotherThreadServesTheFrame)
{
  const Image plain = this->Shown.render();
  Scene ahead{ jitteredLattice(8, 0.15, 5, sineField()) };
  bool prepared = false;
  std::thread thread([&] { prepared = ahead.Mapper->PrepareMesh(); });
  thread.join();
  EXPECT_TRUE(prepared);
  EXPECT_EQ(ahead.Mapper->GetMeshBuilds(), 1);
  EXPECT_EQ(ahead.Mapper->GetScalarsBuilds(), 0); // no frame was drawn
  const Image picture = ahead.render();
  EXPECT_EQ(ahead.Mapper->GetMeshBuilds(), 1);
  EXPECT_EQ(picture.Rgba, plain.Rgba);
  EXPECT_TRUE(ahead.Mapper->PrepareMesh()); // again: nothing to do
  EXPECT_EQ(ahead.Mapper->GetMeshBuilds(), 1);
}

TEST_F(PrepareMesh, StopsWithoutAnError)
{
  const ErrorWatch watch(this->mapper());
  {
    Stop stop(this->mapper());
    EXPECT_FALSE(this->mapper()->PrepareMesh());
    EXPECT_EQ(stop.Reports, 1);
  }
  EXPECT_TRUE(watch.Errors.empty());
  Stop count(this->mapper(), false);
  EXPECT_TRUE(this->mapper()->PrepareMesh());
  EXPECT_GT(count.Reports, 3);
}

TEST_F(PrepareMesh, TellsWhatIsWrong)
{
  vtkNew<Mapper> empty;
  const ErrorWatch none(empty);
  EXPECT_FALSE(empty->PrepareMesh());
  ASSERT_EQ(none.Errors.size(), 1u);
  EXPECT_NE(none.Errors[0].find("no input"), std::string::npos);

  this->mapper()->SetMaxMemoryInBytes(1000);
  const ErrorWatch watch(this->mapper());
  EXPECT_FALSE(this->mapper()->PrepareMesh());
  EXPECT_EQ(watch.Errors.size(), 1u);
}

TEST_F(PrepareMesh, OfAGridWithoutCellsIsNothing)
{
  vtkNew<vtkUnstructuredGrid> empty;
  this->mapper()->SetInputData(empty);
  const ErrorWatch watch(this->mapper());
  EXPECT_FALSE(this->mapper()->PrepareMesh());
  EXPECT_TRUE(watch.Errors.empty());
}

TEST(GroundTruth, StopsWithoutAnErrorAndCanBeAskedForAgain)
{
  Scene scene{ jitteredLattice(4, 0.15, 5, sineField()) };
  scene.render();
  vtkNew<vtkFloatArray> pixels;
  const ErrorWatch watch(scene.Mapper);
  {
    Stop stop(scene.Mapper);
    EXPECT_FALSE(scene.Mapper->RenderGroundTruth(scene.Volume, pixels));
    EXPECT_EQ(stop.Reports, 1);
    EXPECT_FALSE(scene.Mapper->CompareWithGroundTruth(scene.Volume));
  }
  EXPECT_EQ(pixels->GetNumberOfTuples(), 0);
  EXPECT_TRUE(watch.Errors.empty());
  Stop count(scene.Mapper, false);
  EXPECT_TRUE(scene.Mapper->RenderGroundTruth(scene.Volume, pixels));
  EXPECT_GT(count.Reports, 3);
  EXPECT_EQ(pixels->GetNumberOfTuples(), SceneSize * SceneSize);
}

} // namespace
