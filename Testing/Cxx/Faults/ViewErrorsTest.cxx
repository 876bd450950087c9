// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Ranges that a view mode can't show give an error that says what to do, and nothing is drawn.
#include "ErrorScene.h"

#include <limits>

namespace
{
using namespace tetmarch::testing;

class ViewErrors : public ErrorScene
{
protected:
  void expectErrorOfRange(int mode, double low, double high, const std::string& words)
  {
    this->expectError(
      [=]
      {
        this->Shown.Mapper->SetViewMode(mode);
        this->Shown.Mapper->SetViewRange(low, high);
        this->Shown.Mapper->AutomaticViewRangeOff();
      },
      [=] { this->Shown.Mapper->SetViewModeToPicture(); }, { words, "SetViewRange()" });
  }
};

TEST_F(ViewErrors, BadRanges)
{
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr int bound = vtkTetMarchVolumeMapper::VIEW_ERROR_BOUND;
  constexpr int cells = vtkTetMarchVolumeMapper::VIEW_CELLS;
  this->expectErrorOfRange(cells, 5.0, 5.0, "below the second");
  this->expectErrorOfRange(vtkTetMarchVolumeMapper::VIEW_LOOKUPS, 6.0, 5.0, "below the second");
  this->expectErrorOfRange(cells, 0.0, inf, "finite");
  this->expectErrorOfRange(cells, std::numeric_limits<double>::quiet_NaN(), 1.0, "finite");
  this->expectErrorOfRange(bound, 0.0, 1.0, "begins above 0");
  this->expectErrorOfRange(bound, -1.0, 1.0, "begins above 0");
}

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
