// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A view mode refuses a range that it can't show, and draws the next one. A volume that is out of
// sight is no error.
#include "ErrorScene.h"

namespace
{
using namespace tetmarch::testing;

class ViewErrors : public ErrorScene
{
};

TEST_F(ViewErrors, NextGoodRangeDraws)
{
  this->Shown.Mapper->SetViewModeToErrorBound();
  const Image view = this->frame();
  EXPECT_GT(compare(view, this->Empty).Max, 0.1);
  ErrorWatch watch(this->Shown.Mapper);
  this->Shown.Mapper->AutomaticViewRangeOff();
  this->Shown.Mapper->SetViewRange(2.0, 1.0);
  this->expectEmpty();
  EXPECT_EQ(this->Shown.Mapper->GetNumberOfDraws(), 0);
  this->Shown.Mapper->SetViewRange(1.0, 2.0);
  const Image fixed = this->frame();
  EXPECT_GT(compare(fixed, this->Empty).Max, 0.1);
  EXPECT_GT(compare(fixed, view).Max, 0.1);
  this->Shown.Mapper->AutomaticViewRangeOn();
  EXPECT_EQ(compare(this->frame(), view).Max, 0.0);
  EXPECT_EQ(watch.Errors.size(), 1u);
}

TEST_F(ViewErrors, NothingToShowIsNone)
{
  this->Shown.Mapper->SetViewModeToCells();
  vtkNew<vtkUnstructuredGrid> empty;
  this->show(empty);
  this->expectEmptyWithoutErrors();
  this->showSound();
  const Image view = this->frame();
  this->Shown.camera()->SetFocalPoint(20.0, 0.0, 0.0); // the mesh is out of sight
  this->expectEmptyWithoutErrors();
  lookAtUnitCube(this->Shown.camera());
  EXPECT_EQ(compare(this->frame(), view).Max, 0.0);
}

TEST_F(ViewErrors, ModesAreClamped)
{
  vtkTetMarchVolumeMapper* mapper = this->Shown.Mapper;
  EXPECT_EQ(mapper->GetViewMode(), vtkTetMarchVolumeMapper::VIEW_PICTURE);
  EXPECT_STREQ(mapper->GetViewModeAsString(), "Picture");
  mapper->SetViewMode(99);
  EXPECT_STREQ(mapper->GetViewModeAsString(), "BoundaryCoordinates");
  mapper->SetViewMode(-1);
  EXPECT_STREQ(mapper->GetViewModeAsString(), "Picture");
  this->expectSound();
}
} // namespace
