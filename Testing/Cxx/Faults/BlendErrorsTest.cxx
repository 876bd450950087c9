// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Unknown blend modes, and more surfaces than can be drawn, are errors.
#include "ErrorScene.h"

#include "vtkContourValues.h"
#include "vtkVolumeMapper.h"

namespace
{
using namespace tetmarch::testing;

class BlendErrors : public ErrorScene
{
};

TEST_F(BlendErrors, NumbersAreThoseOfVolumeMappers)
{
  using Ours = vtkTetMarchVolumeMapper;
  using Theirs = vtkVolumeMapper;
  EXPECT_EQ(int(Ours::COMPOSITE_BLEND), int(Theirs::COMPOSITE_BLEND));
  EXPECT_EQ(int(Ours::MAXIMUM_INTENSITY_BLEND), int(Theirs::MAXIMUM_INTENSITY_BLEND));
  EXPECT_EQ(int(Ours::MINIMUM_INTENSITY_BLEND), int(Theirs::MINIMUM_INTENSITY_BLEND));
  EXPECT_EQ(int(Ours::AVERAGE_INTENSITY_BLEND), int(Theirs::AVERAGE_INTENSITY_BLEND));
  EXPECT_EQ(int(Ours::ADDITIVE_BLEND), int(Theirs::ADDITIVE_BLEND));
  EXPECT_EQ(int(Ours::ISOSURFACE_BLEND), int(Theirs::ISOSURFACE_BLEND));
}

TEST_F(BlendErrors, UnknownModes)
{
  const std::vector<int> modes{ static_cast<int>(vtkVolumeMapper::SLICE_BLEND), -1, 99 };
  for (const int mode : modes)
  {
    this->expectError([=] { this->Shown.Mapper->SetBlendMode(mode); },
      [this] { this->Shown.Mapper->SetBlendModeToComposite(); },
      { "blend mode is " + std::to_string(mode), "isosurface (5)" });
  }
}

TEST_F(BlendErrors, TooManySurfaces)
{
  vtkContourValues* contours = this->Shown.property()->GetIsoSurfaceValues();
  const auto spoil = [&]
  {
    contours->SetNumberOfContours(40);
    for (int i = 0; i < 40; ++i)
    {
      contours->SetValue(i, 0.02 * i);
    }
    this->Shown.Mapper->SetBlendModeToIsoSurface();
  };
  this->expectError(spoil, [this] { this->Shown.Mapper->SetBlendModeToComposite(); },
    { "40 isosurface values", "at most 32" });
}
} // namespace
