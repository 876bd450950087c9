// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What several blocks can't be asked for, and blocks that can't be drawn.
#include "ErrorWatch.h"
#include "SmartBlocks.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkProperty.h"
#include "vtkTable.h"

namespace
{
using namespace tetmarch::testing;

// What goes through the whole volume can't be drawn block by block.
TEST_F(SmartBlocks, OtherBlendModesAreErrors)
{
  vtkTetMarchSmartVolumeMapper* mapper = this->Shown.Mapper;
  mapper->SetInputDataObject(inBlocks(this->Whole, Cuts[0].Planes));
  const Image sound = this->Shown.frame();
  ErrorWatch watch(mapper);
  mapper->SetBlendModeToMaximumIntensity();
  this->Shown.frame();
  ASSERT_EQ(watch.Errors.size(), 1u);
  EXPECT_NE(watch.Errors[0].find("blend mode"), std::string::npos) << watch.Errors[0];
  mapper->SetBlendModeToComposite();
  EXPECT_EQ(compare(this->Shown.frame(), sound).Max, 0.0);
  EXPECT_EQ(watch.Errors.size(), 1u);
}

// One image is drawn in parts between the peels; what several would show there is not.
TEST_F(SmartBlocks, AreNotDrawnBetweenPeels)
{
  SmartScene& scene = this->Shown;
  scene.Window->AlphaBitPlanesOn();
  const auto plane = makePlane(0.5, 0.2, { { 0.9, 0.2, 0.1 } });
  plane->GetProperty()->SetOpacity(0.5);
  scene.Renderer->SetUseDepthPeeling(true);
  scene.Renderer->SetUseDepthPeelingForVolumes(true);
  scene.Renderer->AddActor(plane);
  scene.Volume->VisibilityOff();
  const Image empty = scene.frame();
  scene.Volume->VisibilityOn();
  const Image sound = scene.frame();
  const auto tree = inBlocks(this->Whole, Cuts[0].Planes);
  scene.Mapper->SetInputDataObject(tree);
  const ErrorWatch watch(scene.Mapper);
  EXPECT_EQ(compare(scene.frame(), empty).Max, 0.0);
  ASSERT_EQ(watch.Errors.size(), 1u);
  EXPECT_NE(watch.Errors[0].find("UseDepthPeelingForVolumes"), std::string::npos);
  scene.Mapper->SetInputDataObject(this->Whole);
  EXPECT_EQ(compare(scene.frame(), sound).Max, 0.0);
  EXPECT_EQ(watch.Errors.size(), 1u);
}

TEST_F(SmartBlocks, HaveNoDiagnostics)
{
  vtkTetMarchSmartVolumeMapper* mapper = this->Shown.Mapper;
  mapper->SetInputDataObject(inBlocks(this->Whole, Cuts[0].Planes));
  const Image picture = this->Shown.frame();
  mapper->CollectDiagnosticsOn();
  mapper->SetViewModeToErrorBound();
  EXPECT_EQ(compare(this->Shown.frame(), picture).Max, 0.0);
  EXPECT_EQ(mapper->GetNumberOfRays(), 0);
  const ErrorWatch watch(mapper);
  EXPECT_FALSE(mapper->TraceRay(
    this->Shown.Volume, 48, 48, vtkTetMarchSmartVolumeMapper::TRACE_FLOAT, vtkNew<vtkTable>()));
  EXPECT_FALSE(mapper->RenderGroundTruth(this->Shown.Volume, vtkNew<vtkFloatArray>()));
  EXPECT_EQ(watch.Errors.size(), 2u);
}

// A tree with one block is drawn as the block.
TEST_F(SmartBlocks, OneHasAllOfIt)
{
  const Image alone = this->Shown.floats();
  vtkNew<vtkMultiBlockDataSet> tree;
  tree->SetBlock(3, this->Whole);
  this->Shown.Mapper->SetInputDataObject(tree);
  EXPECT_EQ(compare(this->Shown.floats(), alone).Max, 0.0);
  this->Shown.Mapper->SetBlendModeToMaximumIntensity();
  const ErrorWatch watch(this->Shown.Mapper);
  this->Shown.frame();
  EXPECT_EQ(watch.Errors, std::vector<std::string>());
  EXPECT_TRUE(this->Shown.Mapper->Pick(this->Shown.Renderer, this->Shown.Volume, 48, 48));
  EXPECT_EQ(this->Shown.Mapper->GetPickedBlock(), 4u);
}

TEST_F(SmartBlocks, ThoseWithoutTheArrayAreNamed)
{
  const auto tree = inBlocks(this->Whole, Cuts[0].Planes);
  vtkNew<vtkImageData> bare;
  bare->CopyStructure(this->Whole);
  tree->SetBlock(2, bare);
  tree->GetMetaData(2u)->Set(vtkCompositeDataSet::NAME(), "bare one");
  this->Shown.Mapper->SetInputDataObject(inBlocks(this->Whole, Cuts[0].Planes));
  const Image sound = this->Shown.frame();
  const ErrorWatch watch(this->Shown.Mapper);
  this->Shown.Mapper->SetInputDataObject(tree);
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_EQ(compare(this->Shown.frame(), sound).Max, 0.0);
    ASSERT_EQ(watch.Warnings.size(), 1u);
  }
  EXPECT_NE(watch.Warnings[0].find("bare one"), std::string::npos) << watch.Warnings[0];
  EXPECT_EQ(watch.Errors, std::vector<std::string>());
}
} // namespace
