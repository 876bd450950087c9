// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The picture of structured data is the same in any window, and after any other.
#include "GLObjects.h"
#include "SmartScene.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 80;

vtkSmartPointer<vtkImageData> makeImage() { return imageOf(sineField(), unitCube(7)); }

class SmartWindows : public testing::Test
{
protected:
  SmartScene Shown{ makeImage(), Side, Side };
};

TEST_F(SmartWindows, InTwoRenderers)
{
  const Image alone = this->Shown.frame();
  vtkNew<vtkRenderer> right;
  right->AddVolume(this->Shown.Volume);
  right->SetActiveCamera(this->Shown.Renderer->GetActiveCamera());
  this->Shown.Window->SetSize(2 * Side, Side);
  this->Shown.Renderer->SetViewport(0, 0, 0.5, 1);
  right->SetViewport(0.5, 0, 1, 1);
  this->Shown.Window->AddRenderer(right);
  const Image both = this->Shown.frame();
  EXPECT_EQ(compare(cropped(both, 0, 0, Side, Side), alone).Max, 0.0);
  EXPECT_EQ(compare(cropped(both, Side, 0, Side, Side), alone).Max, 0.0);
}

TEST_F(SmartWindows, OfOnePixel)
{
  const Image large = this->Shown.frame();
  this->Shown.Window->SetSize(1, 1);
  const Image pixel = this->Shown.frame();
  EXPECT_GT(*std::max_element(pixel.Rgba.begin(), pixel.Rgba.begin() + 3), 0.1f);
  this->Shown.Window->SetSize(Side, Side);
  EXPECT_EQ(compare(this->Shown.frame(), large).Max, 0.0);
}

TEST_F(SmartWindows, OneAfterTheOther)
{
  const Image first = this->Shown.frame();
  SmartScene other(makeImage(), Side, Side);
  EXPECT_EQ(compare(other.frameBy(this->Shown.Mapper), first).Max, 0.0);
  EXPECT_EQ(compare(this->Shown.frame(), first).Max, 0.0);
}

TEST_F(SmartWindows, AfterRelease)
{
  const Image first = this->Shown.frame();
  const std::int64_t builds = this->Shown.Mapper->GetMeshBuilds();
  EXPECT_GT(this->Shown.Mapper->GetGPUMemoryBytes(), 0);
  this->Shown.Mapper->ReleaseGraphicsResources(this->Shown.Window);
  EXPECT_EQ(this->Shown.Mapper->GetGPUMemoryBytes(), 0);
  EXPECT_EQ(compare(this->Shown.frame(), first).Max, 0.0);
  EXPECT_EQ(this->Shown.Mapper->GetMeshBuilds(), builds) << "only the GPU had forgotten it";
}

TEST_F(SmartWindows, NothingIsLeftOfAMapper)
{
  std::array<int, 5> held{};
  const auto drawByAnother = [&]
  {
    vtkNew<vtkTetMarchSmartVolumeMapper> brief;
    this->Shown.frameBy(brief);
    held = countGLObjects();
  };
  drawByAnother(); // VTK's window keeps what it made for all
  const auto before = countGLObjects();
  drawByAnother();
  EXPECT_NE(held, before);
  EXPECT_EQ(countGLObjects(), before);
}

TEST_F(SmartWindows, OfOneDataAfterAnother)
{
  const Image first = this->Shown.frame();
  const auto grid = rectilinearOf(linearField(), unevenCube(5));
  SmartScene fresh(grid, Side, Side);
  const Image second = fresh.frame();
  EXPECT_GT(compare(first, second).Max, 0.1);
  this->Shown.Mapper->SetInputDataObject(grid);
  EXPECT_EQ(compare(this->Shown.frame(), second).Max, 0.0);
  this->Shown.Mapper->SetInputDataObject(this->Shown.Data);
  EXPECT_EQ(compare(this->Shown.frame(), first).Max, 0.0);
}

// What the settings ask for is redone, and nothing else.
TEST_F(SmartWindows, OnlyWhatHasChangedIsRedone)
{
  this->Shown.frame();
  vtkTetMarchSmartVolumeMapper* mapper = this->Shown.Mapper;
  const auto builds = [mapper]
  {
    return std::array{ mapper->GetMeshBuilds(), mapper->GetScalarsBuilds(),
      mapper->GetTablesBuilds() };
  };
  EXPECT_EQ(builds(), (std::array<vtkTypeInt64, 3>{ 1, 1, 1 }));
  EXPECT_EQ(mapper->GetNumberOfLatticeCells(), 7 * 7 * 7);
  this->Shown.Renderer->GetActiveCamera()->Azimuth(20);
  this->Shown.frame();
  EXPECT_EQ(builds(), (std::array<vtkTypeInt64, 3>{ 1, 1, 1 }));
  this->Shown.property()->GetScalarOpacity()->AddPoint(0.2, 0.9);
  this->Shown.frame();
  EXPECT_EQ(builds(), (std::array<vtkTypeInt64, 3>{ 1, 1, 2 }));
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectScalarArray("c");
  this->Shown.frame();
  EXPECT_EQ(mapper->GetScalarsBuilds(), 2);
}
} // namespace
