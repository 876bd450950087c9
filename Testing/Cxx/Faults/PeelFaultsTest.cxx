// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whatever the GL refuses of the parts of a volume between translucent surfaces.
#include "FaultScene.h"

#include "vtkActor.h"
#include "vtkProperty.h"

#include <string>

namespace
{
using namespace tetmarch::testing;

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

// Each part of the volume is drawn by itself: parts beside the one that meets the fault may be
// seen.
TEST_F(PeelFaults, EveryCall)
{
  const struct
  {
    Fault Kind;
    bool OfShaders;
  } cases[] = { { Fault::BufferData, false }, { Fault::TexBuffer, false },
    { Fault::CompileStatus, true }, { Fault::LinkStatus, true } };
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

// The surfaces are drawn all the same. The shader of peeled parts is one of its own.
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
} // namespace
