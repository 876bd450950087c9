// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The stages of a frame, for both kinds of volume: which stages run again, the messages for errors
// and for frames that show nothing, and the scene of the CPU reference.
#include "Frame/FrameScene.h"
#include "Frame/NothingVisible.h"

#include "NonConvexGrids.h"
#include "StagedFrame.h"

#include "vtkContourValues.h"
#include "vtkDoubleArray.h"
#include "vtkLight.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr int Size = 24;

template <typename VolumeOf>
class FrameStagesOf
  : public ::testing::Test
  , protected StagedFrame<VolumeOf>
{
protected:
  // How many stages run in one more update.
  std::int64_t newRuns()
  {
    const std::int64_t before = this->Stages.runs();
    EXPECT_TRUE(this->update().isDone());
    return this->Stages.runs() - before;
  }

  // The error of an update, by its words; the next one without the fault is done.
  template <typename Break, typename Mend>
  void expectError(const char* words, const Break& fault, const Mend& mend)
  {
    fault();
    const StageResult result = this->update();
    EXPECT_NE(result.Error.find(words), std::string::npos) << words << ": " << result.Error;
    mend();
    EXPECT_TRUE(this->update().isDone()) << "after " << words;
  }

  // Why nothing is visible, by its words.
  template <typename Hide, typename Unhide>
  void expectInvisible(const char* words, const Hide& hide, const Unhide& unhide)
  {
    hide();
    EXPECT_EQ(this->update().Error, "");
    const std::string why = whyNothingIsVisible(this->Stages);
    EXPECT_NE(why.find(words), std::string::npos) << words << ": " << why;
    unhide();
    EXPECT_TRUE(this->update().isDone()) << "after " << words;
    EXPECT_EQ(whyNothingIsVisible(this->Stages), "") << "after " << words;
  }
};

using Kinds = ::testing::Types<TetVolume, StructuredVolume>;
TYPED_TEST_SUITE(FrameStagesOf, Kinds, );

TYPED_TEST(FrameStagesOf, RunAgainWhenTheirInputChanged)
{
  EXPECT_GT(this->newRuns(), 0);
  EXPECT_EQ(this->newRuns(), 0);
  const Fingerprint content = this->Stages.contentVersion();
  this->Renderer->GetActiveCamera()->SetPosition(3.0, 2.0, 1.0);
  EXPECT_EQ(this->newRuns(), 0);
  EXPECT_EQ(this->Stages.contentVersion(), content);
  this->show({ { 0.3, 0.0 }, { 1.0, 0.5 } });
  EXPECT_EQ(this->newRuns(), 2); // tables, and what they show
  EXPECT_NE(this->Stages.contentVersion(), content);
  this->property()->ShadeOn();
  vtkNew<vtkLight> light;
  this->Renderer->AddLight(light);
  EXPECT_EQ(this->newRuns(), 1); // gradients
  this->Input.Drawn.Scalars.Array->Modified();
  EXPECT_GE(this->newRuns(), 3);
}

TYPED_TEST(FrameStagesOf, SayWhatIsWrong)
{
  auto& drawn = this->Input.Drawn;
  vtkNew<vtkDoubleArray> few;
  few->InsertNextValue(1.0);
  this->expectError(
    "1 tuple", [&] { drawn.Scalars.Array = few; },
    [&] { drawn.Scalars.Array = this->Data->GetPointData()->GetScalars(); });
  vtkNew<vtkDoubleArray> pairs;
  pairs->SetNumberOfComponents(2);
  pairs->SetNumberOfTuples(this->Data->GetNumberOfPoints());
  pairs->Fill(0.5);
  this->expectError(
    "Several components",
    [&]
    {
      drawn.Scalars.Array = pairs;
      drawn.Vector.Mode = VectorMode::AllComponents;
      drawn.Blend.Mode = static_cast<int>(BlendMode::Maximum);
    },
    [&] { drawn.Blend.Mode = static_cast<int>(BlendMode::Composite); });
  EXPECT_NE(this->Stages.describeBadSamples().find("one component"), std::string::npos);
  vtkNew<vtkLight> light;
  this->Renderer->AddLight(light);
  this->expectError(
    "choose one component by VectorMode",
    [&]
    {
      this->property()->ShadeOn();
      this->Input.Effects.Shadows = ShadowMethod::AtVertices;
    },
    [&]
    {
      this->property()->ShadeOff();
      this->Input.Effects.Shadows = ShadowMethod::Off;
    });
  drawn.Vector.Mode = VectorMode::Component;
  drawn.Scalars.Array = this->Data->GetPointData()->GetScalars();
  this->expectError(
    "unit distance", [&] { this->property()->SetScalarOpacityUnitDistance(0.0); },
    [&] { this->property()->SetScalarOpacityUnitDistance(1.0); });
  this->expectError(
    "singular", [&] { this->Volume->SetScale(1.0, 0.0, 1.0); },
    [&] { this->Volume->SetScale(1.0); });
  EXPECT_NE(this->Stages.describeBadSamples(), "");
  drawn.Samples.Distance = 0.1;
  EXPECT_TRUE(this->update().isDone());
  EXPECT_EQ(this->Stages.describeBadSamples().empty(), this->Marched.isStructured());
}

TYPED_TEST(FrameStagesOf, TellWhyNothingIsVisible)
{
  auto& drawn = this->Input.Drawn;
  const auto composite = [&] { this->blend(BlendMode::Composite); };
  this->expectInvisible(
    "opacity is 0",
    [&] {
      this->show({ { 0.0, 0.0 }, { 1.0, 0.0 } });
    },
    [&] {
      this->show({ { 0.0, 0.1 }, { 1.0, 0.6 } });
    });
  vtkContourValues* surfaces = this->property()->GetIsoSurfaceValues();
  surfaces->SetNumberOfContours(0);
  this->expectInvisible(
    "no isosurface values", [&] { this->blend(BlendMode::IsoSurface); }, composite);
  this->expectInvisible(
    "lies among",
    [&]
    {
      this->blend(BlendMode::IsoSurface);
      surfaces->SetValue(0, 7.0);
    },
    composite);
  this->expectInvisible(
    "at the isosurface values",
    [&]
    {
      this->blend(BlendMode::IsoSurface);
      surfaces->SetValue(0, 0.0);
      this->show({ { 0.0, 0.0 }, { 1.0, 1.0 } });
    },
    composite);
  this->expectInvisible(
    "AverageIPScalarRange",
    [&]
    {
      this->blend(BlendMode::Average);
      drawn.Blend.AverageRange = { { 3.0, 4.0 } };
    },
    composite);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.0, 0.0, 1.0);
  plane->SetOrigin(0.0, 0.0, 9.0);
  vtkNew<vtkPlaneCollection> planes;
  planes->AddItem(plane);
  this->expectInvisible(
    "clipping planes", [&] { drawn.Cuts.Planes = planes; }, [&] { drawn.Cuts.Planes = nullptr; });
  vtkNew<vtkDoubleArray> none;
  none->SetNumberOfTuples(this->Data->GetNumberOfPoints());
  none->Fill(std::numeric_limits<double>::quiet_NaN());
  this->expectInvisible(
    "finite number", [&] { drawn.Scalars.Array = none; },
    [&] { drawn.Scalars.Array = this->Data->GetPointData()->GetScalars(); });
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName("vtkGhostType");
  ghosts->SetNumberOfTuples(this->Data->GetNumberOfPoints());
  ghosts->Fill(vtkDataSetAttributes::HIDDENPOINT);
  this->expectInvisible(
    "ghost", [&] { this->Data->GetPointData()->AddArray(ghosts); },
    [&] { this->Data->GetPointData()->RemoveArray("vtkGhostType"); });
}

TYPED_TEST(FrameStagesOf, GiveTheirTablesToTheReference)
{
  constexpr std::uint64_t limit = 20000;
  // A steep step needs the finest tables.
  this->property()->GetScalarOpacity()->AddPoint(0.4, 0.1);
  this->property()->GetScalarOpacity()->AddPoint(0.4 + 1e-9, 0.9);
  ASSERT_TRUE(this->update().isDone());
  this->Stages.setLimits({ limit, 0 });
  ASSERT_EQ(this->update().Error, "");
  const FrameScene asDrawn(this->Stages, this->property(), this->Input.Level, false);
  const FrameScene truth(this->Stages, this->property(), this->Input.Level, true);
  const auto& drawn = asDrawn.scene().Table->Values;
  EXPECT_LE(drawn.size(), limit);
  EXPECT_EQ(drawn, this->Stages.tables().first().Values);
  EXPECT_GT(truth.scene().Table->Values.size(), drawn.size());
}

TYPED_TEST(FrameStagesOf, AreDrawnByTheReference)
{
  ASSERT_TRUE(this->update().isDone());
  ASSERT_EQ(this->Stages.prepareEntrySearch(), "");
  FrameScene made(this->Stages, this->property(), this->Input.Level, false);
  made.scene().Width = made.scene().Height = Size;
  const ReferenceImage image = made.render<double>();
  TraceOptions options;
  options.X = options.Y = Size / 2;
  options.InDouble = true;
  const RayTrace trace = made.trace(options);
  const float* pixel = &image.Pixels[4 * (Size / 2 * Size + Size / 2)];
  ASSERT_FALSE(trace.Cells.empty());
  EXPECT_GT(pixel[3], 0.05f);
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_EQ(pixel[k], static_cast<float>(trace.Color[k]));
  }
  options.InDouble = false;
  EXPECT_NEAR(made.trace(options).Color[3], trace.Color[3], 1e-4);
}

// Lists tell where rays of pixels enter a mesh, but in a parallel projection from inside.
TEST(FrameStages, TheHierarchyIsMadeWhenRaysSearchInIt)
{
  using Frame = StagedFrame<TetVolume>;
  const struct
  {
    const char* What;
    void (*Change)(Frame&);
    bool IfConvex, IfConcave;
  } cases[] = {
    { "a picture from outside", [](Frame&) {}, false, false },
    { "surfaces in light", [](Frame& frame) { frame.shine(3, 4, 1); }, false, false },
    { "shadows at vertices", [](Frame& frame) { frame.castShadow(); }, false, true },
    { "shadows along rays", [](Frame& frame) { frame.castShadow(ShadowMethod::AlongRays); }, false,
      true },
    { "ambient occlusion",
      [](Frame& frame)
      {
        frame.shine(3, 4, 1);
        frame.Input.Effects.Occlusion = true;
      },
      false, true },
    { "a camera inside",
      [](Frame& frame) { frame.Renderer->GetActiveCamera()->SetPosition(0.4, 0.4, 0.4); }, false,
      false },
    { "a camera inside, parallel",
      [](Frame& frame)
      {
        frame.Renderer->GetActiveCamera()->SetPosition(0.4, 0.4, 0.4);
        frame.Renderer->GetActiveCamera()->ParallelProjectionOn();
      },
      true, true },
    { "a camera inside, the greatest value of each ray",
      [](Frame& frame)
      {
        frame.Renderer->GetActiveCamera()->SetPosition(0.4, 0.4, 0.4);
        frame.blend(BlendMode::Maximum);
      },
      false, false },
  };
  for (const auto& each : cases)
  {
    for (const bool isConvex : { true, false })
    {
      SCOPED_TRACE(std::string(each.What) + (isConvex ? ", convex" : ", concave"));
      Frame frame;
      frame.draw(isConvex ? jitteredLattice(2) : lShape(2));
      each.Change(frame);
      EXPECT_TRUE(frame.update().isDone());
      EXPECT_EQ(frame.Marched.mesh().hasHierarchy(), isConvex ? each.IfConvex : each.IfConcave);
    }
  }
}

} // namespace
