// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whatever the GL refuses, in frames of each kind: one error that says what, a frame without the
// volume, nothing left behind, and the volume is back as soon as the GL takes it.
#include "BlendScene.h"
#include "FaultScene.h"

#include "vtkActor.h"
#include "vtkProperty.h"

#include <vector>

namespace
{
using namespace tetmarch::testing;

class FrameWithFaults;
using Change = std::function<void(FrameWithFaults&)>;

struct Frame
{
  const char* Name;
  Change SetUp;
  // Kinds of calls that fail, and the minimum number of calls that end the frame.
  std::vector<std::pair<Fault, int>> Faults;
  // Words of a shader that the frame needs, and the error when they are replaced.
  const char* Spoilt = nullptr;
  const char* Said = nullptr;
  bool IsAgain = false;
  bool InParts = false;
  Change Free = {}; // instead of releasing all resources of the mapper
  // First calls that fail after `Free` in one frame after the other, and the error that is
  // reported.
  std::vector<std::pair<Fault, const char*>> Refused = {};
};

void PrintTo(const Frame& frame, std::ostream* to) { *to << frame.Name; }

class FrameWithFaults
  : public FaultScene<BlendScene>
  , public testing::WithParamInterface<Frame>
{
public:
  // The surfaces are drawn as before and after: no program is left in use.
  void addBall()
  {
    this->Shown.property()->ShadeOff();
    this->Shown.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
  }
  void addGlass()
  {
    this->Shown.property()->ShadeOff();
    this->Shown.Window->AlphaBitPlanesOn();
    this->Shown.Renderer->UseDepthPeelingOn();
    this->Shown.Renderer->UseDepthPeelingForVolumesOn();
    this->Shown.Renderer->SetMaximumNumberOfPeels(4);
    this->Shown.Renderer->SetOcclusionRatio(0.0);
    const auto layer = makePlane(0.5, 0.2, { 0.9, 0.3, 0.2 });
    layer->GetProperty()->SetOpacity(0.4);
    this->Shown.Renderer->AddActor(layer);
  }
  void addEffects()
  {
    this->Shown.addGradientOpacity();
    this->Mapper->SetShadowMethodToAtVertices();
  }
  // Frees all that effects keep on the GPU, and nothing else, and switches them on again.
  void freeEffects()
  {
    this->Shown.property()->ShadeOff();
    this->Shown.property()->DisableGradientOpacityOn();
    this->Shown.Window->Render();
    this->Shown.property()->DisableGradientOpacityOff();
    this->Shown.property()->ShadeOn();
  }
  vtkTetMarchVolumeMapper* mapper() { return this->Mapper; }
};

TEST_P(FrameWithFaults, MeetsThemAtEveryCall)
{
  const Frame& frame = this->GetParam();
  frame.SetUp(*this);
  this->lookOnce();
  EXPECT_EQ(this->Mapper->Frames > 1, frame.InParts);
  for (const auto& [fault, ending] : frame.Faults)
  {
    const bool ofShaders = fault == Fault::CompileStatus || fault == Fault::LinkStatus;
    this->expectEveryCallIsMet({ fault, ending, frame.IsAgain, frame.InParts },
      [&] { frame.Free ? frame.Free(*this) : this->release(ofShaders); });
  }
  EXPECT_EQ(this->Mapper->GetMeshBuilds(), 1);
  EXPECT_TRUE(frame.Free || this->Mapper->GetGradientsBuilds() <= 1);
  for (const auto& [fault, said] : frame.Refused)
  {
    this->Watch.Errors.clear();
    for (int i = 0; i < 3; ++i)
    {
      if (frame.Free)
      {
        frame.Free(*this); // draws a frame without an error
        this->Watch.Errors.clear();
      }
      else
      {
        this->release(false);
      }
      EXPECT_TRUE(this->meet(fault, 0));
      this->expectEmpty(this->Shown.frame());
      this->expectReported(said);
    }
    this->expectSound(this->frame());
  }
  if (frame.Spoilt)
  {
    this->expectSpoiltShader(frame.Spoilt, frame.Said);
  }
}

using Faults = std::vector<std::pair<Fault, int>>;

Faults allFaults()
{
  Faults all;
  for (const Fault fault : AllFaults)
  {
    all.push_back({ fault, 1 });
  }
  return all;
}

std::vector<Frame> frames()
{
  const auto inView = [](int mode) -> Change
  {
    return [mode](FrameWithFaults& f)
    {
      f.addBall();
      f.mapper()->CollectDiagnosticsOn();
      f.mapper()->SetViewMode(mode);
    };
  };
  const auto addEffects = [](FrameWithFaults& f) { f.addEffects(); };
  const auto few = [](FrameWithFaults& f)
  {
    f.addBall();
    f.mapper()->AutoAdjustSampleDistancesOff();
    f.mapper()->SetImageSampleDistance(3.0);
  };
  const auto adaptive = [](FrameWithFaults& f)
  {
    f.addBall();
    f.mapper()->SetPixelTolerance(4.0 / 255.0);
  };
  const auto compute = [](FrameWithFaults& f)
  {
    f.addBall();
    f.mapper()->SetShaderStageToCompute();
  };
  std::vector<Frame> all = {
    { "Picture", inView(Mapper::VIEW_PICTURE), allFaults(), nullptr, nullptr, true, false, {},
      { { Fault::BufferData, "no room for a buffer of" },
        { Fault::TexBuffer, "no texture of a buffer" } } },
    { "View", inView(Mapper::VIEW_CELLS), allFaults(), nullptr, nullptr, true },
    { "BoundaryView", inView(Mapper::VIEW_BOUNDARY_FACES), allFaults(), nullptr, nullptr, true },
    { "FewRays", few,
      { { Fault::FramebufferStatus, 2 }, { Fault::TexImage, 3 }, { Fault::Blit, 1 },
        { Fault::CompileStatus, 4 }, { Fault::LinkStatus, 2 } },
      "pictureTexture", "full_view.vert.glsl and passes/enlarge.frag.glsl could not be built" },
    { "AdaptiveRays", adaptive,
      { { Fault::FramebufferStatus, 8 }, { Fault::TexImage, 8 }, { Fault::CompileStatus, 8 },
        { Fault::LinkStatus, 8 } },
      "pixelTolerance", "full_view.vert.glsl and passes/new_rays.frag.glsl could not be built" },
    { "Compute", compute,
      { { Fault::CompileStatus, 3 }, { Fault::LinkStatus, 2 }, { Fault::TexImage, 2 } },
      "placeInGroup(", "compute shader passes/march.comp.glsl could not be built" },
    { "Effects", addEffects, { { Fault::CompileStatus, 4 }, { Fault::LinkStatus, 2 } },
      "vertexStartBuffer",
      "The shader of passes/tile.vert.glsl and passes/vertex_light.frag.glsl could not be built" },
    // Gradients, gradient opacity, starts of rays and the target of the light, when all else is
    // there.
    { "EffectsAlone", addEffects,
      { { Fault::BufferData, 3 }, { Fault::TexBuffer, 3 }, { Fault::TexImage, 1 },
        { Fault::FramebufferStatus, 1 } },
      nullptr, nullptr, false, false, [](FrameWithFaults& f) { f.freeEffects(); },
      { { Fault::TexImage, "no room for 1 16-bit texture(s) of 4096 x 8 pixels" } } },
    { "Parts", [](FrameWithFaults& f) { f.addGlass(); },
      { { Fault::BufferData, 1 }, { Fault::TexBuffer, 1 }, { Fault::CompileStatus, 1 },
        { Fault::LinkStatus, 1 } },
      "void initializeRayCast", "tile.vert.glsl and passes/march.frag.glsl could not be built",
      true, true },
  };
  static const char* const names[] = { "Composite", "Maximum", "Minimum", "Average", "Additive",
    "IsoSurface" };
  for (const int mode : BlendModes)
  {
    all.push_back({ names[mode], [mode](FrameWithFaults& f) { f.mapper()->SetBlendMode(mode); },
      { { Fault::BufferData, 6 }, { Fault::LinkStatus, 1 } } });
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Each, FrameWithFaults, testing::ValuesIn(frames()),
  [](const auto& of) { return std::string(of.param.Name); });
} // namespace
