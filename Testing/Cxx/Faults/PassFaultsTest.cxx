// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whatever the GL refuses of frames with fewer rays than pixels, and of other blend modes.
#include "BlendScene.h"
#include "FaultScene.h"

#include "vtkActor.h"

namespace
{
using namespace tetmarch::testing;

class CoarseFaults : public FaultScene<Scene>
{
protected:
  CoarseFaults()
  {
    this->Shown.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
    this->Mapper->AutoAdjustSampleDistancesOff();
    this->Mapper->SetImageSampleDistance(3.0);
    this->lookOnce();
    EXPECT_EQ(this->Mapper->GetUsedImageSampleDistance(), 3.0);
  }
};

TEST_F(CoarseFaults, NoRoomForTheCoarsePicture)
{
  this->Mapper->SetImageSampleDistance(1.0);
  const Image full = this->frame();
  const vtkTypeInt64 bytes = this->Mapper->GetGPUMemoryBytes();
  const auto objects = countGLObjects();
  this->Mapper->SetImageSampleDistance(1.0 + 1e-9); // as many rays: all else stays
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_TRUE(this->meet(Fault::TexImage, 0));
    this->expectEmpty(this->Shown.frame());
    EXPECT_EQ(this->Mapper->GetGPUMemoryBytes(), bytes);
    EXPECT_EQ(countGLObjects(), objects);
  }
  this->expectReported("no room for 1 16-bit texture(s) of 64 x 64 pixels");
  EXPECT_LE(compare(this->frame(), full).Max, 1.0 / 255.0);
  EXPECT_EQ(this->Watch.Errors.size(), 1u);
}

class BlendFaults : public FaultScene<BlendScene>
{
};

// A mode that is refused frees nothing that the next one needs.
TEST_F(BlendFaults, OneModeAfterTheOther)
{
  for (const int mode : BlendModes)
  {
    this->Mapper->SetBlendMode(mode);
    this->lookOnce();
    this->Watch.Errors.clear();
    this->Mapper->SetBlendMode(6);
    this->expectEmpty(this->frame());
    this->expectReported("The blend mode is 6");
    this->Mapper->SetBlendMode(mode);
    this->expectSound(this->frame());
  }
}
} // namespace
