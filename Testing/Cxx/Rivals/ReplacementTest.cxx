// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Code that was written for vtkProjectedTetrahedraMapper runs with ours.
#include "ErrorWatch.h"
#include "Scene.h"

#include "vtkTetMarchObjectFactory.h"
#include "vtkTetMarchProjectedTetrahedraMapper.h"

#include "vtkAutoInit.h"
#include "vtkCallbackCommand.h"
#include "vtkProjectedTetrahedraMapper.h"

#include <gtest/gtest.h>

VTK_MODULE_INIT(vtkRenderingVolumeOpenGL2);

namespace
{
using namespace tetmarch::testing;
using Factory = vtkTetMarchObjectFactory;
using Replacement = vtkTetMarchProjectedTetrahedraMapper;

bool makesReplacement()
{
  const auto made = vtkSmartPointer<vtkProjectedTetrahedraMapper>::New();
  return Replacement::SafeDownCast(made) != nullptr;
}

TEST(Replacement, IsMadeWhereItIsAskedFor)
{
  EXPECT_FALSE(Factory::GetReplacesProjectedTetrahedra());
  EXPECT_FALSE(makesReplacement());
  const auto stock = vtkSmartPointer<vtkProjectedTetrahedraMapper>::New();
  for (int turn = 0; turn < 2; ++turn)
  {
    Factory::SetReplacesProjectedTetrahedra(true);
    Factory::SetReplacesProjectedTetrahedra(true);
    EXPECT_TRUE(Factory::GetReplacesProjectedTetrahedra());
    EXPECT_TRUE(makesReplacement());
    Factory::SetReplacesProjectedTetrahedra(false);
    EXPECT_FALSE(Factory::GetReplacesProjectedTetrahedra());
    // The one of before, not its abstract base.
    const auto again = vtkSmartPointer<vtkProjectedTetrahedraMapper>::New();
    EXPECT_STREQ(again->GetClassName(), stock->GetClassName());
  }
}

class Replaced : public testing::Test
{
protected:
  Replaced()
  {
    Factory::SetReplacesProjectedTetrahedra(true);
    this->Mapper = vtkSmartPointer<vtkProjectedTetrahedraMapper>::New();
    Factory::SetReplacesProjectedTetrahedra(false);
    this->Shown.Mapper->CollectDiagnosticsOff();
  }

  Image draw(vtkAbstractVolumeMapper* mapper)
  {
    this->Shown.Volume->SetMapper(mapper);
    this->Shown.Window->Render();
    return this->Shown.frame();
  }

  Scene Shown{ jitteredLattice(6, 0.15, 1, sineField()) };
  vtkSmartPointer<vtkProjectedTetrahedraMapper> Mapper;
};

TEST_F(Replaced, DrawsWhatTheMarchingMapperDraws)
{
  this->Mapper->SetInputData(this->Shown.Data);
  ASSERT_TRUE(this->Mapper->IsSupported(this->Shown.Window));
  const Image points = this->draw(this->Shown.Mapper);
  EXPECT_EQ(this->draw(this->Mapper).Rgba, points.Rgba);
  EXPECT_GT(this->Mapper->GetTimeToDraw(), 0.0);

  this->Shown.drawCellScalars();
  const Image cells = this->draw(this->Shown.Mapper);
  EXPECT_NE(cells.Rgba, points.Rgba);
  this->Mapper->SetScalarModeToUseCellFieldData();
  this->Mapper->SelectScalarArray("c");
  EXPECT_EQ(this->draw(this->Mapper).Rgba, cells.Rgba);

  // Its own properties are within reach, and it takes another grid.
  auto* replacement = Replacement::SafeDownCast(this->Mapper);
  replacement->GetMarchingMapper()->SetOpacityLawToStructured();
  EXPECT_NE(this->draw(this->Mapper).Rgba, cells.Rgba);
  this->Mapper->SetInputData(jitteredLattice(4, 0.15, 2, sineField()));
  this->draw(this->Mapper);
  EXPECT_EQ(replacement->GetMarchingMapper()->GetMeshBuilds(), 2);
}

TEST_F(Replaced, GraphicsResourcesAreReleased)
{
  this->Mapper->SetInputData(this->Shown.Data);
  const Image picture = this->draw(this->Mapper);
  auto* marching = Replacement::SafeDownCast(this->Mapper)->GetMarchingMapper();
  EXPECT_GT(marching->GetGPUMemoryBytes(), 0);
  this->Mapper->ReleaseGraphicsResources(this->Shown.Window);
  EXPECT_EQ(marching->GetGPUMemoryBytes(), 0);
  EXPECT_EQ(this->draw(this->Mapper).Rgba, picture.Rgba);
}

// Who observes the mapper hears of errors and of progress.
TEST_F(Replaced, EventsAreForwarded)
{
  this->Mapper->SetInputData(this->Shown.Data);
  ErrorWatch watch(this->Mapper);
  this->Mapper->SetScalarModeToUseCellFieldData();
  this->Mapper->SelectScalarArray("not there");
  this->draw(this->Mapper);
  ASSERT_EQ(watch.Errors.size(), 1u);
  EXPECT_NE(watch.Errors[0].find("not there"), std::string::npos) << watch.Errors[0];
  this->Mapper->SetScalarModeToDefault();
  int calls = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&calls);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  this->Mapper->AddObserver(vtkCommand::ProgressEvent, count);
  Replacement::SafeDownCast(this->Mapper)->GetMarchingMapper()->SetMaxDrawTimeInSeconds(1e-6);
  for (int i = 0; i < 3; ++i)
  {
    this->draw(this->Mapper);
  }
  EXPECT_GT(calls, 0);
}
} // namespace
