// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Values in several textures: what is too large, what finds no room, and what is left behind.
#include "ErrorWatch.h"
#include "GLObjects.h"
#include "SmallTextures.h"
#include "StructuredComponents.h"

#include "vtkActor.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

constexpr int Cells = 11;

class SlabFaults : public testing::Test
{
protected:
  SlabFaults()
  {
    this->Sound = this->Shown.render();
    this->release();
    this->None = countGLObjects();
  }

  void release() { this->Shown.Mapper->ReleaseGraphicsResources(this->Shown.Window); }

  // One error with these words, however often it is drawn, and nothing of the volume on the GPU.
  void expectRefused(const TextureLimits& limits, const std::vector<std::string>& words)
  {
    this->Watch.Errors.clear();
    for (int frame = 0; frame < 2; ++frame)
    {
      const SmallTextures small(limits);
      this->Shown.Window->Render();
    }
    ASSERT_EQ(this->Watch.Errors.size(), 1u);
    for (const std::string& word : words)
    {
      EXPECT_NE(this->Watch.Errors[0].find(word), std::string::npos)
        << word << ": " << this->Watch.Errors[0];
    }
    EXPECT_EQ(this->Shown.Mapper->GetGPUMemoryBytes(), 0);
    this->release();
    EXPECT_EQ(countGLObjects(), this->None);
  }
  void expectSound()
  {
    this->Watch.Errors.clear();
    EXPECT_EQ(compare(this->Shown.render(), this->Sound).Max, 0.0);
    EXPECT_TRUE(this->Watch.Errors.empty());
    this->release();
  }

  StructuredScene Shown{ imageOf(sineField(), unitCube(Cells)) };
  ErrorWatch Watch{ this->Shown.Mapper };
  Image Sound;
  std::array<int, 5> None{};
};

TEST_F(SlabFaults, TooManyLayers)
{
  TextureLimits limits;
  limits.Layers = 1;
  this->expectRefused(limits,
    { "12 x 12 x 12 values", "the GPU takes 12 x 12 x 8 at most, in 8 textures", "Extract" });
  this->expectSound();
}

// Many slabs would leave none for other textures.
TEST_F(SlabFaults, FewTextureUnits)
{
  TextureLimits limits;
  limits.Units = 16;
  limits.Layers = 5;
  this->expectRefused(limits, { "the GPU takes 12 x 12 x 10 at most, in 2 textures" });
  this->expectSound();
  limits.Layers = 6;
  const SmallTextures small(limits);
  this->expectSound();
  EXPECT_EQ(small.made(), 2);
}

TEST_F(SlabFaults, TooManyOfComponents)
{
  const auto image = imageWith(wavyFields(4), Cells, VTK_FLOAT);
  setComponentFunctions(this->Shown.property(), 4);
  this->Shown.property()->IndependentComponentsOff();
  this->Shown.Mapper->SetInputDataObject(image);
  this->Sound = this->Shown.render();
  this->release();
  TextureLimits limits;
  limits.Layers = 5;
  this->expectRefused(
    limits, { "12 x 12 x 12 values of 4 components",
              "12 x 12 x 10 at most, in 2 textures a component", "draw fewer components" });
  this->expectSound();
}

TEST_F(SlabFaults, NoRoomForTheThird)
{
  TextureLimits limits;
  limits.Layers = 3;
  limits.Textures = 2;
  this->expectRefused(
    limits, { "no room for a texture of 1728 bytes", "number 3 of 4", "Close what else uses it" });
  this->expectSound();
}

TEST_F(SlabFaults, NoRoomForTheOnlyOne)
{
  TextureLimits limits;
  limits.Textures = 0;
  this->expectRefused(limits, { "no room for a texture of 6912 bytes. Close what else" });
  this->expectSound();
}

// Volumes in one texture and in several, by turns; units of textures are given back, too.
TEST_F(SlabFaults, LeaveNothingBehind)
{
  const auto other = imageOf(scatteredField(4), unitCube(23));
  this->Shown.render();
  const auto held = countGLObjects();
  const int units = unitsInUse(this->Shown.Window);
  const vtkTypeInt64 bytes = this->Shown.Mapper->GetGPUMemoryBytes();
  for (const int layers : { 12, 3 })
  {
    TextureLimits limits;
    limits.Layers = layers;
    const SmallTextures small(limits);
    this->Shown.Mapper->SetInputDataObject(other);
    this->Shown.render();
    this->Shown.Mapper->Pick(this->Shown.Renderer, this->Shown.Volume, 20, 20);
    EXPECT_EQ(small.made(), 24 / layers);
    EXPECT_EQ(unitsInUse(this->Shown.Window), units);
    // Of values, all but one; other images of the lattice have no texture of their own.
    EXPECT_EQ(countGLObjects()[0] - held[0], 24 / layers - 1);
    this->Shown.Mapper->SetInputDataObject(this->Shown.Data);
    this->Shown.render();
    EXPECT_EQ(unitsInUse(this->Shown.Window), units);
    EXPECT_EQ(countGLObjects()[0] - held[0], 12 / layers - 1);
    EXPECT_EQ(this->Shown.Mapper->GetGPUMemoryBytes(), bytes);
    this->release();
    EXPECT_EQ(countGLObjects(), this->None);
  }
  this->expectSound();
}
} // namespace
