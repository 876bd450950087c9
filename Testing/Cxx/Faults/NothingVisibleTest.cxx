// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A frame that shows nothing, whatever the camera looks at, says why, once.
#include "BlankScenes.h"

#include "vtkCellData.h"
#include "vtkMultiBlockDataSet.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

template <typename SceneType>
class NothingVisible : public testing::Test
{
};
using Scenes = testing::Types<Scene, ImageScene>;
TYPED_TEST_SUITE(NothingVisible, Scenes);

TYPED_TEST(NothingVisible, IsSaidOnce)
{
  for (const auto& blank : blanks<TypeParam>())
  {
    SCOPED_TRACE(blank.Name);
    TypeParam scene(soundOf(static_cast<TypeParam*>(nullptr)), 48, 48);
    const ErrorWatch watch(scene.Mapper);
    scene.Window->Render();
    ASSERT_EQ(watch.Warnings, Words()) << "all is visible at first";
    scene.Volume->VisibilityOff();
    scene.Window->Render();
    const Image empty = scene.frame();
    scene.Volume->VisibilityOn();
    blank.Spoil(scene);
    scene.Window->Render();
    scene.Window->Render();
    EXPECT_EQ(compare(scene.frame(), empty).Max, 0.0);
    ASSERT_EQ(watch.Warnings.size(), 1U);
    const std::string text = watch.Warnings[0];
    EXPECT_NE(text.find("Nothing is visible, because "), std::string::npos) << text;
    for (const std::string& word : blank.Said)
    {
      EXPECT_NE(text.find(word), std::string::npos) << text;
    }
    EXPECT_EQ(watch.Errors, Words());
  }
}

// What is hardly visible, or out of sight, is nothing to say a word about.
TYPED_TEST(NothingVisible, IsNotSaidOfALittle)
{
  const Blank<TypeParam> little[] = {
    { "one peak",
      [](TypeParam& s) {
        setOpacities(s, { { { 0.49, 0 } }, { { 0.5, 1 } }, { { 0.51, 0 } } });
      },
      {} },
    { "one of two isosurfaces",
      [](TypeParam& s) {
        setIsoValues(s, { 0.5, 3.0 });
      },
      {} },
    { "a corner left",
      [](TypeParam& s) {
        cropTo(s, { 0.9, 2, 0.9, 2, 0.9, 2 }, 0x2000);
      },
      {} },
    { "a corner region",
      [](TypeParam& s) {
        cropTo(s, { 0.1, 2, 0.1, 2, 0.1, 2 }, 0x1);
      },
      {} },
    { "a slab",
      [](TypeParam& s)
      {
        addPlane(s, 0.499, 1.0);
        addPlane(s, 0.501, -1.0);
      },
      {} },
    { "averages of some",
      [](TypeParam& s)
      {
        s.Mapper->SetBlendModeToAverageIntensity();
        s.Mapper->SetAverageIPScalarRange(-7.0, 0.5);
      },
      {} },
    { "one cell left",
      [](TypeParam& s)
      { markCells(s.Data, vtkDataSetAttributes::HIDDENCELL, [](vtkIdType c) { return c != 9; }); },
      {} },
    { "looking away",
      [](TypeParam& s) { s.Renderer->GetActiveCamera()->SetFocalPoint(20.0, 0.0, 0.0); }, {} },
  };
  for (const auto& scarce : little)
  {
    SCOPED_TRACE(scarce.Name);
    TypeParam scene(soundOf(static_cast<TypeParam*>(nullptr)), 48, 48);
    const ErrorWatch watch(scene.Mapper);
    scarce.Spoil(scene);
    scene.Window->Render();
    EXPECT_EQ(watch.Warnings, Words());
    EXPECT_EQ(watch.Errors, Words());
  }
}

TYPED_TEST(NothingVisible, IsSaidAgainWhenItIsSoAgain)
{
  TypeParam scene(madeNotFinite(soundOf(static_cast<TypeParam*>(nullptr))), 48, 48);
  const ErrorWatch watch(scene.Mapper);
  const auto warnings = [&]
  {
    scene.Window->Render();
    return watch.Warnings.size();
  };
  EXPECT_EQ(warnings(), 1U);
  scene.Mapper->DrawNanCellsOn(); // but the colour function's NaN colour is transparent
  scene.property()->GetRGBTransferFunction()->SetNanColorRGBA(1.0, 0.0, 0.0, 0.0);
  EXPECT_EQ(warnings(), 1U);
  scene.property()->GetRGBTransferFunction()->SetNanColorRGBA(1.0, 0.0, 0.0, 0.5);
  EXPECT_EQ(warnings(), 1U) << "they are drawn";
  scene.Mapper->DrawNanCellsOff();
  EXPECT_EQ(warnings(), 2U) << "it is so again";
  addPlane(scene, 1.8, 1.0);
  scene.Data->GetPointData()->GetScalars()->Fill(0.5);
  scene.Data->GetPointData()->GetScalars()->Modified();
  scene.Data->Modified();
  EXPECT_EQ(warnings(), 3U) << "for another reason";
  scene.Mapper->RemoveAllClippingPlanes();
  EXPECT_EQ(warnings(), 3U);
  EXPECT_EQ(watch.Errors, Words());
}

// Where a script has switched VTK's messages off, what it misses is said when they are on again.
TYPED_TEST(NothingVisible, IsSaidWhenSomebodyHears)
{
  TypeParam scene(madeNotFinite(soundOf(static_cast<TypeParam*>(nullptr))), 48, 48);
  const ErrorWatch watch(scene.Mapper);
  vtkObject::GlobalWarningDisplayOff();
  scene.Window->Render();
  vtkObject::GlobalWarningDisplayOn();
  EXPECT_EQ(watch.Warnings.size(), 0U);
  scene.Window->Render();
  EXPECT_EQ(watch.Warnings.size(), 1U);
}

// Between the least and the greatest value are some that no cell has.
TEST(NothingVisibleOfCells, OpacityBetweenTheirValues)
{
  Scene scene(jitteredLattice(4, 0.1, 1, sineField()), 48, 48);
  vtkDataArray* values = scene.Data->GetCellData()->GetArray("c");
  for (vtkIdType cell = 0; cell < values->GetNumberOfTuples(); ++cell)
  {
    values->SetTuple1(cell, cell % 2);
  }
  scene.drawCellScalars();
  setOpacities(scene, { { { 0.4, 0 } }, { { 0.5, 1 } }, { { 0.6, 0 } } });
  const ErrorWatch watch(scene.Mapper);
  scene.Window->Render();
  ASSERT_EQ(watch.Warnings.size(), 1U);
  EXPECT_NE(watch.Warnings[0].find("no cell has a value that is shown"), std::string::npos)
    << watch.Warnings[0];
}

TEST(NothingVisibleOfBlocks, OneThatIsVisibleIsEnough)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  const auto first = imageOf(sineField(), unitCube(6));
  const auto second = madeNotFinite(imageOf(sineField(), unitCube(6)));
  second->SetOrigin(1.0, 0.0, 0.0);
  blocks->SetBlock(0, first);
  blocks->SetBlock(1, second);
  SmartScene scene(blocks, 48, 48);
  const ErrorWatch watch(scene.Mapper);
  scene.Window->Render();
  EXPECT_EQ(watch.Warnings, Words());
  madeNotFinite(first);
  scene.Window->Render();
  EXPECT_EQ(watch.Warnings.size(), 1U);
  EXPECT_EQ(watch.Errors, Words());
}
} // namespace
