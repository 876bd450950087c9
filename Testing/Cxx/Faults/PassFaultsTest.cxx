// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whatever the GL refuses of frames with fewer rays than pixels, of other blend modes, of parts
// between translucent surfaces, and of picks and selections.
#include "BlendScene.h"
#include "FaultScene.h"
#include "PickScene.h"

#include "vtkActor.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>

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

// Nothing is half enlarged, and a frame with all rays doesn't need what this one lacks.
TEST_F(CoarseFaults, EveryCall)
{
  const auto releaseData = [this] { this->release(false); };
  const auto releaseAll = [this] { this->release(true); };
  this->expectEveryCallIsMet(Fault::FramebufferStatus, releaseData, 3);
  this->expectEveryCallIsMet(Fault::TexImage, releaseData, 3);
  this->expectEveryCallIsMet(Fault::Blit, releaseData, 1);
  this->expectEveryCallIsMet(Fault::CompileStatus, releaseAll, 6);
  this->expectEveryCallIsMet(Fault::LinkStatus, releaseAll, 3);
  EXPECT_EQ(this->Mapper->GetMeshBuilds(), 1);
}

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

TEST_F(CoarseFaults, ShaderThatEnlarges)
{
  const auto spoil = [](const std::string& text) { return spoilt(text, "pictureTexture"); };
  for (int i = 0; i < 2; ++i)
  {
    this->release(true);
    EXPECT_TRUE(this->meet(spoil));
    this->expectEmpty(this->Shown.frame());
  }
  this->expectReported("full_view.vert.glsl and passes/enlarge.frag.glsl could not be built");
  this->expectSound(this->frame());
}

class BlendFaults : public FaultScene<BlendScene>
{
};

TEST_F(BlendFaults, EveryCallInEachMode)
{
  for (const int mode : BlendModes)
  {
    SCOPED_TRACE(mode);
    this->Mapper->SetBlendMode(mode);
    this->lookOnce();
    this->expectEveryCallIsMet(
      Fault::BufferData, [this] { this->release(false); }, 6);
    this->expectEveryCallIsMet(
      Fault::LinkStatus, [this] { this->release(true); }, 2);
  }
}

// A mode that is refused lets go of nothing that the next one needs.
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

class PeelFaults : public FaultScene<Scene>
{
protected:
  PeelFaults()
  {
    this->Shown.Window->AlphaBitPlanesOn();
    this->Shown.Renderer->UseDepthPeelingOn();
    this->Shown.Renderer->UseDepthPeelingForVolumesOn();
    this->Shown.Renderer->SetMaximumNumberOfPeels(4);
    this->Shown.Renderer->SetOcclusionRatio(0.0);
    this->Layer->GetProperty()->SetOpacity(0.4);
    this->Shown.Renderer->AddActor(this->Layer);
    this->lookOnce();
    EXPECT_GT(this->Mapper->Frames, 1); // several a frame
  }

  vtkSmartPointer<vtkActor> Layer = makePlane(0.5, 0.2, { 0.9, 0.3, 0.2 });
};

// A part that is drawn before or after the one that meets the fault may be seen in that frame.
TEST_F(PeelFaults, EveryCall)
{
  const struct
  {
    Fault Kind;
    bool OfShaders;
  } cases[] = { { Fault::BufferData, false }, { Fault::TexBuffer, false },
    { Fault::TexImage, false }, { Fault::FramebufferStatus, false }, { Fault::CompileStatus, true },
    { Fault::LinkStatus, true } };
  for (const auto& c : cases)
  {
    this->release(c.OfShaders);
    const auto objects = countGLObjects();
    int calls = 0;
    int errors = 0;
    for (; calls < 100; ++calls)
    {
      SCOPED_TRACE(std::string(nameOf(c.Kind)) + ", call " + std::to_string(calls));
      this->Watch.Errors.clear();
      if (!this->meet(c.Kind, calls))
      {
        this->expectSound(this->Shown.frame());
        break;
      }
      errors += this->Watch.Errors.empty() ? 0 : 1;
      EXPECT_LE(compare(this->frame(), this->Sound).Max, 2.0 / 255.0);
      this->release(c.OfShaders);
      EXPECT_EQ(countGLObjects(), objects);
      this->expectSound(this->frame());
      this->release(c.OfShaders);
    }
    EXPECT_GT(errors, 0) << nameOf(c.Kind);
    std::cout << "[ MEASURED ] " << nameOf(c.Kind) << ": " << calls << " calls, " << errors
              << " of them are reported\n";
  }
  EXPECT_EQ(this->Mapper->GetMeshBuilds(), 1);
}

// Surfaces are drawn all the same, and without peels there is another shader.
TEST_F(PeelFaults, ShaderOfTheParts)
{
  const auto spoil = [](const std::string& text) { return spoilt(text, "void initializeRayCast"); };
  for (int i = 0; i < 2; ++i)
  {
    this->release(true);
    EXPECT_TRUE(this->meet(spoil));
    this->expectEmpty(this->Shown.frame());
  }
  this->expectReported("tile.vert.glsl and passes/march.frag.glsl could not be built");
  this->expectSound(this->frame());
  EXPECT_EQ(this->Watch.Errors.size(), 1u);
}

class PickFaults : public FaultScene<PickScene>
{
protected:
  static constexpr int Middle = Side / 2;

  PickFaults()
  {
    this->Shown.property()->SetScalarOpacityUnitDistance(0.1);
    this->lookOnce();
    this->All = this->cells();
    EXPECT_GT(this->All.size(), 50u);
    EXPECT_TRUE(this->pick());
    this->Hit = this->Mapper->GetPickedCellId();
  }

  // Of the volume, in all of the window.
  std::set<vtkIdType> cells() { return this->Shown.selectAll()[this->Shown.Volume]; }
  bool pick()
  {
    return this->Mapper->Pick(this->Shown.Renderer, this->Shown.Volume, Middle, Middle);
  }

  std::set<vtkIdType> All;
  vtkIdType Hit = -1;
};

TEST_F(PickFaults, EveryCallOfASelection)
{
  for (const Fault fault : AllFaults)
  {
    const bool ofShaders = fault == Fault::CompileStatus || fault == Fault::LinkStatus;
    this->release(ofShaders);
    const auto objects = countGLObjects();
    int calls = 0;
    int errors = 0;
    for (; calls < 100; ++calls)
    {
      SCOPED_TRACE(std::string(nameOf(fault)) + ", call " + std::to_string(calls));
      this->Watch.Errors.clear();
      std::set<vtkIdType> found;
      const bool met = this->meetIn([&] { found = this->cells(); }, fault, calls);
      if (!met || this->Watch.Errors.empty())
      {
        EXPECT_EQ(found, this->All);
      }
      if (!met)
      {
        break;
      }
      errors += this->Watch.Errors.empty() ? 0 : 1;
      EXPECT_EQ(this->cells(), this->All);
      this->release(ofShaders);
      EXPECT_EQ(countGLObjects(), objects);
    }
    EXPECT_GT(errors, 0) << nameOf(fault);
    std::cout << "[ MEASURED ] " << nameOf(fault) << ": " << calls << " calls, " << errors
              << " of them are reported\n";
  }
  this->expectSound(this->frame());
  EXPECT_EQ(this->Mapper->GetMeshBuilds(), 1);
}

// What is picked is right, or nothing is: a selector asks in several passes, each of which may
// fail.
TEST_F(PickFaults, EveryCallOfAPick)
{
  for (const Fault fault : AllFaults)
  {
    const bool ofShaders = fault == Fault::CompileStatus || fault == Fault::LinkStatus;
    for (int calls = 0; calls < 100; ++calls)
    {
      SCOPED_TRACE(std::string(nameOf(fault)) + ", call " + std::to_string(calls));
      this->release(ofShaders);
      this->Watch.Errors.clear();
      bool hit = false;
      const bool met = this->meetIn([&] { hit = this->pick(); }, fault, calls);
      EXPECT_EQ(hit, this->Watch.Errors.empty());
      EXPECT_EQ(this->Mapper->GetPickedCellId(), hit ? this->Hit : -1);
      EXPECT_EQ(std::isnan(this->Mapper->GetPickedScalar()), !hit);
      EXPECT_TRUE(this->pick());
      EXPECT_EQ(this->Mapper->GetPickedCellId(), this->Hit);
      if (!met)
      {
        break;
      }
    }
  }
}

// In one of the selector's passes alone, of which some draw nothing of the volume.
TEST_F(PickFaults, InOnePassOfAPick)
{
  int failed = 0;
  for (int pass = 0; pass < 6; ++pass)
  {
    SCOPED_TRACE(pass);
    this->Watch.Errors.clear();
    int passes = 0;
    bool met = false;
    this->Mapper->Around = [&](const std::function<void()>& draw)
    {
      const FaultyGL faulty(Fault::FramebufferStatus, passes++ == pass ? 0 : 1000);
      draw();
      met = met || faulty.happened();
    };
    const bool hit = this->pick();
    this->Mapper->Around = nullptr;
    EXPECT_EQ(hit, !met);
    EXPECT_EQ(this->Watch.Errors.size(), met ? 1u : 0u);
    EXPECT_EQ(this->Mapper->GetPickedCellId(), hit ? this->Hit : -1);
    failed += met ? 1 : 0;
  }
  EXPECT_GT(failed, 1);
}

TEST_F(PickFaults, AreReportedOnce)
{
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_TRUE(this->meetIn([this] { EXPECT_FALSE(this->pick()); }, Fault::TexImage, 0));
  }
  ASSERT_GE(this->Watch.Errors.size(), 1u);
  for (const std::string& error : this->Watch.Errors)
  {
    EXPECT_NE(error.find("The GPU has no room for"), std::string::npos) << error;
  }
  EXPECT_TRUE(this->pick());
  this->expectSound(this->frame());
}
} // namespace
