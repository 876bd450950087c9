// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What vtkTetMarchWebExporter writes of a window, and what it leaves as it was. Whether a browser
// draws the same picture is tested in Testing/Web.
#include "vtkTetMarchWebExporter.h"

#include "ErrorWatch.h"
#include "Lights.h"
#include "Scene.h"
#include "vtkTetMarchSmartVolumeMapper.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkTransform.h"

#include "vtk_jsoncpp.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <iterator>

namespace
{
using namespace tetmarch::testing;
namespace fs = std::filesystem;

Json::Value sceneOf(const std::string& page)
{
  const std::string begin = "<script type=\"application/json\" id=\"scene\">";
  const std::size_t from = page.find(begin) + begin.size();
  const std::string text = page.substr(from, page.find("</script>", from) - from);
  Json::Value scene;
  std::istringstream(text) >> scene;
  return scene;
}

class WebExporter : public testing::Test
{
protected:
  WebExporter()
  {
    this->Exporter->SetRenderWindow(this->Shown.Window);
    this->Shown.Mapper->CollectDiagnosticsOff();
    this->Shown.Window->Render();
  }

  Json::Value scene()
  {
    const std::string page = this->Exporter->WriteToString();
    EXPECT_FALSE(page.empty());
    return sceneOf(page);
  }

  // Expects one error, that contains these words.
  void expectError(const std::string& words, const std::function<void()>& act)
  {
    ErrorWatch watch(this->Exporter);
    act();
    ASSERT_EQ(watch.Errors.size(), 1u) << words;
    EXPECT_NE(watch.Errors[0].find(words), std::string::npos) << watch.Errors[0];
  }

  Scene Shown{ jitteredLattice(4, 0.15, 1, sineField()), 120, 90 };
  vtkNew<vtkTetMarchWebExporter> Exporter;
};

TEST_F(WebExporter, LeavesThePictureAndTheWindow)
{
  this->Shown.Renderer->SetUseDepthPeeling(true);
  this->Shown.Renderer->SetUseDepthPeelingForVolumes(true);
  this->Shown.Window->Render();
  const Image before = this->Shown.frame();
  EXPECT_EQ(this->scene()["steps"][0]["volumes"].size(), 1u);
  EXPECT_EQ(this->Shown.frame().Rgba, before.Rgba);
  EXPECT_TRUE(this->Shown.Renderer->GetUseDepthPeeling());
  EXPECT_TRUE(this->Shown.Renderer->GetUseDepthPeelingForVolumes());
  EXPECT_TRUE(this->Shown.Window->GetSwapBuffers());
  this->Shown.Window->Render();
  EXPECT_EQ(this->Shown.frame().Rgba, before.Rgba);
}

TEST_F(WebExporter, WritesAgainAfterARelease)
{
  const std::string page = this->Exporter->WriteToString();
  this->Shown.Volume->ReleaseGraphicsResources(this->Shown.Window);
  EXPECT_EQ(this->Exporter->WriteToString(), page);
}

TEST_F(WebExporter, NamesAreText)
{
  const std::string name = "</script><img src=x onerror=alert(1)>";
  this->Shown.Data->GetPointData()->GetScalars()->SetName(name.c_str());
  const std::string page = this->Exporter->WriteToString();
  EXPECT_EQ(page.find(name), std::string::npos);
  EXPECT_EQ(page.find("<img src=x"), std::string::npos);
  EXPECT_EQ(sceneOf(page)["steps"][0]["volumes"][0]["name"].asString(), name);
  EXPECT_EQ(sceneOf(page)["title"].asString(), name);
}

TEST_F(WebExporter, SaysWhatIsWrong)
{
  const fs::path folder =
    fs::temp_directory_path() / ("tetmarch-page-" + std::to_string(std::random_device()()));
  this->expectError("no path", [&] { this->Exporter->Write(); });
  this->Exporter->SetFileName((folder / "page.html").c_str()); // there is no such folder
  this->expectError("could not be written", [&] { this->Exporter->Write(); });
  fs::create_directory(folder);
  this->Exporter->SetRenderWindow(nullptr);
  this->expectError("no scene", [&] { this->Exporter->WriteToString(); });
  EXPECT_FALSE(fs::exists(folder / "page.html"));
  this->Exporter->SetRenderWindow(this->Shown.Window);
  this->Exporter->Write();
  std::ifstream file(folder / "page.html", std::ios::binary);
  const std::string text{ std::istreambuf_iterator<char>(file), {} };
  EXPECT_EQ(text, this->Exporter->WriteToString());
  fs::remove_all(folder);
}

TEST_F(WebExporter, SaysWhatIsLeftOut)
{
  vtkNew<vtkVolume> other;
  vtkNew<vtkProjectedTetrahedraMapper> rival;
  vtkNew<vtkRenderer> second;
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  this->Shown.Renderer->AddLight(light);
  this->Shown.Window->AddRenderer(second);
  EXPECT_EQ(this->scene()["omissions"].size(), 0u);
  vtkNew<vtkTransform> moved;
  rival->SetInputData(this->Shown.Data);
  other->SetMapper(rival);
  const struct
  {
    const char* Words;
    std::function<void()> Change;
    std::function<void()> Undo;
  } cases[] = {
    { "its mapper is a ", [&] { this->Shown.Renderer->AddVolume(other); },
      [&] { this->Shown.Renderer->RemoveVolume(other); } },
    { "view mode", [&] { this->Shown.Mapper->SetViewMode(vtkTetMarchVolumeMapper::VIEW_CELLS); },
      [&] { this->Shown.Mapper->SetViewMode(vtkTetMarchVolumeMapper::VIEW_PICTURE); } },
    { "one renderer", [&] { second->AddVolume(other); }, [&] { second->RemoveVolume(other); } },
    { "Lights that follow the camera", [&] { this->Shown.property()->ShadeOn(); },
      [&] { this->Shown.property()->ShadeOff(); } },
    { "Lights that follow the camera", [&] { this->Shown.Mapper->SetLightPresetToStudio(); },
      [&] { this->Shown.Mapper->SetLightPresetToOfScene(); } },
    { "camera's own transform",
      [&]
      {
        moved->Translate(0.1, 0, 0);
        this->Shown.camera()->SetUserTransform(moved);
      },
      [&] { this->Shown.camera()->SetUserTransform(nullptr); } },
  };
  for (const auto& c : cases)
  {
    c.Change();
    const Json::Value omissions = this->scene()["omissions"];
    ASSERT_EQ(omissions.size(), 1u) << c.Words;
    EXPECT_NE(omissions[0].asString().find(c.Words), std::string::npos) << omissions[0].asString();
    EXPECT_EQ(this->Exporter->GetOmissions(), omissions[0].asString());
    c.Undo();
    EXPECT_EQ(this->scene()["omissions"].size(), 0u) << c.Words;
  }
}

TEST_F(WebExporter, StepsShareWhatIsEqual)
{
  const Json::UInt alone = this->scene()["arrays"].size();
  ASSERT_TRUE(this->Exporter->AddTimeStep("first"));
  vtkDataArray* scalars = this->Shown.Data->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    scalars->SetComponent(i, 0, 0.5 * scalars->GetComponent(i, 0));
  }
  scalars->Modified();
  ASSERT_TRUE(this->Exporter->AddTimeStep("second"));
  const Json::Value scene = this->scene();
  ASSERT_EQ(scene["steps"].size(), 2u);
  EXPECT_EQ(scene["steps"][1]["label"].asString(), "second");
  const auto arrayOf = [&](int step, const char* texture)
  { return scene["steps"][step]["volumes"][0]["textures"][texture]["array"].asInt(); };
  EXPECT_EQ(arrayOf(0, "cellBuffer"), arrayOf(1, "cellBuffer"));
  EXPECT_NE(arrayOf(0, "tableValueBuffer"), arrayOf(1, "tableValueBuffer"));
  EXPECT_LT(scene["arrays"].size(), 2 * alone);
  this->Exporter->ClearTimeSteps();
  EXPECT_EQ(this->scene()["steps"].size(), 1u);
}

TEST_F(WebExporter, WhatShowsNothingIsAPageWithoutVolumes)
{
  this->Shown.property()->GetScalarOpacity()->RemoveAllPoints();
  this->Shown.property()->GetScalarOpacity()->AddPoint(0, 0);
  const Json::Value scene = this->scene();
  EXPECT_EQ(scene["steps"][0]["volumes"].size(), 0u);
  EXPECT_EQ(scene["omissions"].size(), 1u);
}

TEST_F(WebExporter, BlocksOfImagesAreOneGroup)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (const int side : { 0, 1 })
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(3, 3, 3);
    image->SetOrigin(2.0 * side, 0, 0);
    image->AllocateScalars(VTK_FLOAT, 1);
    for (int i = 0; i < 27; ++i)
    {
      image->GetPointData()->GetScalars()->SetComponent(i, 0, i / 26.0);
    }
    image->GetPointData()->GetScalars()->SetName("s");
    blocks->SetBlock(side, image);
  }
  vtkNew<vtkTetMarchSmartVolumeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  mapper->SelectScalarArray("s");
  mapper->SetScalarModeToUsePointFieldData();
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  setBumpyFunctions(volume->GetProperty());
  this->Shown.Renderer->AddVolume(volume);
  const Json::Value volumes = this->scene()["steps"][0]["volumes"];
  ASSERT_EQ(volumes.size(), 3u);
  EXPECT_EQ(volumes[0]["group"], 0);
  EXPECT_EQ(volumes[1]["group"], 1);
  EXPECT_EQ(volumes[2]["group"], 1);
}
} // namespace
