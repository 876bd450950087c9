// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Several components that can't be drawn together: one error says why, and none is left when it is
// put right.
#include "ComponentScene.h"
#include "ErrorWatch.h"

#include <gtest/gtest.h>
#include <string>

namespace
{
using namespace tetmarch::testing;
using Mapper = vtkTetMarchVolumeMapper;

constexpr int Side = 64;

class ComponentErrors : public ::testing::Test
{
protected:
  void expectError(const std::string& words)
  {
    const ErrorWatch watch(this->Shown.Mapper);
    this->Shown.Window->Render();
    this->Shown.Window->Render();
    ASSERT_EQ(watch.Errors.size(), 1u);
    EXPECT_NE(watch.Errors[0].find(words), std::string::npos) << watch.Errors[0];
    EXPECT_EQ(compare(this->Shown.frame(), this->Empty).Max, 0.0);
  }
  void expectMended()
  {
    const ErrorWatch watch(this->Shown.Mapper);
    this->Shown.Window->Render();
    EXPECT_TRUE(watch.Errors.empty());
    EXPECT_EQ(this->Shown.frame().Rgba, this->Sound.Rgba);
  }
  void SetUp() override
  {
    this->Shown.Volume->VisibilityOff();
    this->Shown.Window->Render();
    this->Empty = this->Shown.frame();
    this->Shown.Volume->VisibilityOn();
    this->Shown.Window->Render();
    this->Sound = this->Shown.frame();
    EXPECT_GT(compare(this->Sound, this->Empty).Max, 0.1);
  }

  ComponentScene Shown{ jitteredLattice(6, 0.15, 1, sineField()), { "", 3, true }, Side, Side };
  Image Empty;
  Image Sound;
};

TEST_F(ComponentErrors, OtherBlendModes)
{
  for (const int mode :
    { Mapper::MAXIMUM_INTENSITY_BLEND, Mapper::ADDITIVE_BLEND, Mapper::ISOSURFACE_BLEND })
  {
    this->Shown.Mapper->SetBlendMode(mode);
    this->expectError("composite blending alone");
    this->Shown.Mapper->SetBlendModeToComposite();
    this->expectMended();
  }
}

TEST_F(ComponentErrors, LightAndGradients)
{
  this->Shown.property()->ShadeOn();
  this->expectError("independent components are drawn together without light");
  this->Shown.property()->ShadeOff();
  this->expectMended();
  for (const int view : { Mapper::VIEW_GRADIENTS, Mapper::VIEW_ILLUMINATION })
  {
    this->Shown.Mapper->SetViewMode(view);
    this->expectError("without light");
    this->Shown.Mapper->SetViewModeToPicture();
    this->expectMended();
  }
  this->Shown.property()->GetGradientOpacity()->AddSegment(0.0, 0.0, 5.0, 1.0);
  this->expectError("gradient opacity");
  this->Shown.property()->GetGradientOpacity()->RemoveAllPoints();
  this->Shown.property()->DisableGradientOpacityOn();
  this->expectMended();
}

TEST_F(ComponentErrors, NumbersOfComponents)
{
  this->Shown.property()->IndependentComponentsOff();
  this->expectError("\"components\" has 3 components");
  this->Shown.property()->IndependentComponentsOn();
  this->expectMended();
  this->Shown.property()->SetScalarOpacityUnitDistance(1, -1.0);
  this->expectError("of component 1 is -1");
  this->Shown.property()->SetScalarOpacityUnitDistance(1, 0.375);
  this->expectMended();
}
} // namespace
