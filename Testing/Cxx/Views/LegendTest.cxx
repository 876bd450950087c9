// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The legend of the view modes tells of the frame that it stands in.
#include "ErrorWatch.h"
#include "Scene.h"
#include "vtkTetMarchLegend.h"

#include "vtkAutoInit.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkTetMarchFrameStatistics.h"
#include "vtkTetMarchSmartVolumeMapper.h"

#include <algorithm>
#include <gtest/gtest.h>

// The text of the legend.
VTK_MODULE_INIT(vtkRenderingFreeType);

namespace
{
using namespace tetmarch::testing;

class Legend : public testing::Test
{
protected:
  Legend()
  {
    this->Shown.Mapper->CollectDiagnosticsOff();
    this->Shown.Renderer->SetBackground(0.2, 0.4, 0.6);
    this->Picture = this->frame();
    this->Bar->SetMapper(this->Shown.Mapper);
  }
  Image frame()
  {
    this->Shown.Window->Render();
    return this->Shown.frame();
  }
  // What the legend adds to a frame.
  Difference added(int mode)
  {
    this->Shown.Mapper->SetViewMode(mode);
    this->Shown.Renderer->RemoveViewProp(this->Bar);
    const Image without = this->frame();
    this->Shown.Renderer->AddViewProp(this->Bar);
    return compare(this->frame(), without);
  }

  Scene Shown{ jitteredLattice(5, 0.15, 1, sineField()), 300, 200 };
  vtkNew<vtkTetMarchLegend> Bar;
  ErrorWatch Watch{ this->Bar };
  Image Picture;
};

TEST_F(Legend, IsOfTheFrameInWhichTheModeChanged)
{
  this->Shown.Renderer->AddViewProp(this->Bar);
  this->frame();
  const struct
  {
    int Mode;
    int Quantity;
    const char* Title;
  } cases[] = { { vtkTetMarchVolumeMapper::VIEW_CELLS, vtkTetMarchFrameStatistics::CELLS,
                  "Cells crossed" },
    { vtkTetMarchVolumeMapper::VIEW_ERROR_BOUND, vtkTetMarchFrameStatistics::ERROR_BOUND,
      "Error bound" },
    { vtkTetMarchVolumeMapper::VIEW_LOOKUPS, vtkTetMarchFrameStatistics::LOOKUPS, "Lookups" } };
  for (const auto& c : cases)
  {
    this->Shown.Mapper->SetViewMode(c.Mode);
    const Image first = this->frame();
    EXPECT_STREQ(this->Bar->GetTitle(), c.Title);
    ASSERT_NE(this->Bar->GetLookupTable(), nullptr);
    const double* range = this->Bar->GetLookupTable()->GetRange();
    const double most = this->Shown.Mapper->GetLastFrameStatistics()->GetMaximum(c.Quantity);
    EXPECT_LE(most, range[1]);
    EXPECT_GT(most, range[1] / 10.0);
    EXPECT_EQ(this->Bar->GetLookupTable()->UsingLogScale(),
      c.Mode == vtkTetMarchVolumeMapper::VIEW_ERROR_BOUND ? 1 : 0);
    EXPECT_EQ(this->frame().Rgba, first.Rgba); // the legend was not a frame late
  }
  this->Shown.Mapper->AutomaticViewRangeOff();
  this->Shown.Mapper->SetViewRange(3.0, 14.0);
  const Image first = this->frame();
  EXPECT_EQ(this->Bar->GetLookupTable()->GetRange()[1], 14.0);
  EXPECT_EQ(this->frame().Rgba, first.Rgba);
}

TEST_F(Legend, IsDrawnWithItsText)
{
  const Difference difference = this->added(vtkTetMarchVolumeMapper::VIEW_CELLS);
  EXPECT_GT(difference.Over, 1000u);
  EXPECT_LT(difference.Over, 20000u);
  // Text is white; the palest colour of the bar has 0.72 of blue.
  const Image frame = this->frame();
  int white = 0;
  for (std::size_t i = 0; i < frame.Rgba.size(); i += 4)
  {
    white += *std::min_element(&frame.Rgba[i], &frame.Rgba[i] + 3) > 0.75f;
  }
  EXPECT_GT(white, 50);
  EXPECT_LT(white, 2000);
  EXPECT_EQ(this->Watch.Errors, std::vector<std::string>());
}

TEST_F(Legend, IsNotSeenWithAPicture)
{
  EXPECT_FALSE(this->Bar->IsShown());
  EXPECT_EQ(this->added(vtkTetMarchVolumeMapper::VIEW_PICTURE).Max, 0.0);
  EXPECT_EQ(this->frame().Rgba, this->Picture.Rgba);
  EXPECT_GT(this->added(vtkTetMarchVolumeMapper::VIEW_LOOKUPS).Max, 0.1);
  EXPECT_TRUE(this->Bar->IsShown());
  this->Shown.Mapper->SetViewModeToPicture();
  EXPECT_EQ(this->frame().Rgba, this->Picture.Rgba);
  EXPECT_FALSE(this->Bar->IsShown());
}

// There is nothing to explain, diagnostics or not.
TEST_F(Legend, IsNotSeenWhereColorsAreNoMeasure)
{
  this->Shown.Mapper->CollectDiagnosticsOn();
  for (const int mode : { vtkTetMarchVolumeMapper::VIEW_ILLUMINATION,
         vtkTetMarchVolumeMapper::VIEW_GRADIENTS, vtkTetMarchVolumeMapper::VIEW_BOUNDARY_FACES,
         vtkTetMarchVolumeMapper::VIEW_BOUNDARY_COORDINATES })
  {
    EXPECT_EQ(this->added(mode).Max, 0.0);
    EXPECT_FALSE(this->Bar->IsShown());
  }
  EXPECT_EQ(this->Watch.Errors, std::vector<std::string>());
}

TEST_F(Legend, IsNotSeenWithoutAView)
{
  this->Shown.Mapper->SetViewModeToCells();
  vtkNew<vtkUnstructuredGrid> empty;
  this->Shown.Mapper->SetInputData(empty);
  EXPECT_EQ(this->added(vtkTetMarchVolumeMapper::VIEW_CELLS).Max, 0.0);
  this->Shown.Mapper->SetInputData(this->Shown.Data);
  EXPECT_GT(this->added(vtkTetMarchVolumeMapper::VIEW_CELLS).Max, 0.1);
  this->Bar->SetMapper(nullptr);
  EXPECT_EQ(this->added(vtkTetMarchVolumeMapper::VIEW_CELLS).Max, 0.0);
  EXPECT_EQ(this->Watch.Errors, std::vector<std::string>());
}

TEST_F(Legend, ExplainsFramesOfImages)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  image->AllocateScalars(VTK_FLOAT, 1);
  image->GetPointData()->GetScalars()->Fill(0.5);
  vtkNew<vtkTetMarchSmartVolumeMapper> mapper;
  mapper->SetInputData(image);
  mapper->SetViewModeToCells();
  this->Shown.Volume->SetMapper(mapper);
  this->Shown.Renderer->ResetCamera();
  this->Bar->SetMapper(mapper);
  const Image without = this->frame();
  this->Shown.Renderer->AddViewProp(this->Bar);
  EXPECT_GT(compare(this->frame(), without).Over, 1000u);
  EXPECT_TRUE(this->Bar->IsShown());
  EXPECT_STREQ(this->Bar->GetTitle(), "Cells crossed");
  EXPECT_EQ(this->Bar->GetLookupTable(), mapper->GetViewLookupTable());
  mapper->SetViewModeToPicture();
  this->frame();
  EXPECT_FALSE(this->Bar->IsShown());
  EXPECT_EQ(this->Watch.Errors, std::vector<std::string>());
}

TEST_F(Legend, HasNothingToSayOfOtherMappers)
{
  vtkNew<vtkProjectedTetrahedraMapper> mapper;
  this->Bar->SetMapper(mapper);
  EXPECT_EQ(this->Bar->GetMapper(), mapper.Get());
  EXPECT_FALSE(this->Bar->IsShown());
  EXPECT_EQ(this->added(vtkTetMarchVolumeMapper::VIEW_CELLS).Max, 0.0);
  EXPECT_EQ(this->Watch.Errors, std::vector<std::string>());
}

TEST_F(Legend, OutlivesTheMapper)
{
  auto mapper = vtkSmartPointer<vtkTetMarchVolumeMapper>::New();
  mapper->SetInputData(this->Shown.Data);
  mapper->SetViewModeToCells();
  this->Shown.Volume->SetMapper(mapper);
  this->Bar->SetMapper(mapper);
  this->Shown.Renderer->AddViewProp(this->Bar);
  this->frame();
  EXPECT_TRUE(this->Bar->IsShown());
  this->Shown.Volume->SetMapper(this->Shown.Mapper);
  mapper = nullptr;
  EXPECT_EQ(this->Bar->GetMapper(), nullptr);
  EXPECT_FALSE(this->Bar->IsShown());
  EXPECT_EQ(this->frame().Rgba, this->Picture.Rgba);
}
} // namespace
