// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// After VTK's TestGPURayCastReleaseResources, TestRemoveVolumeNonCurrentContext,
// TestGPURayCastChangedArray and TestGPURayCastVolumeUpdate: what is drawn after something came or
// went is what a new mapper draws.
#include "VtkScene.h"

#include "ErrorWatch.h"

#include "vtkDoubleArray.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkPointData.h"
#include "vtkTrivialProducer.h"

#include <cmath>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 120;

void lookFromTheSide(Scene& scene)
{
  scene.camera()->SetPosition(0.0, 0.0, 1.0);
  scene.camera()->SetFocalPoint(0.0, 0.0, 0.0);
  scene.camera()->SetViewUp(0.0, 1.0, 0.0);
  scene.camera()->Azimuth(-40.0);
  scene.Renderer->ResetCamera();
}

void prepare(Scene& scene, double high = 280.0)
{
  setFunctions(scene.property(), 40.0, high, 0.4);
  scene.property()->SetScalarOpacityUnitDistance(1.0);
  scene.Mapper->SetOpacityLawToStructured();
  lookFromTheSide(scene);
}

TEST(VtkResources, ARendererInAnotherWindowAfterTheFirst)
{
  const Grid grid = tetrahedraOf(makeWavelet());
  Scene scene(grid, Side, Side);
  prepare(scene);
  const ErrorWatch watch(scene.Mapper);
  scene.render();
  scene.Window = nullptr;
  const auto second = makeWindow(Side / 2, Side);
  second->AddRenderer(scene.Renderer);
  second->Render();
  Scene fresh(grid, Side / 2, Side);
  prepare(fresh);
  fresh.Renderer->SetActiveCamera(scene.camera());
  fresh.Window->Render();
  EXPECT_EQ(framePictureOf(second).Rgba, fresh.frame().Rgba);
  EXPECT_EQ(watch.Errors, std::vector<std::string>());
  scene.Renderer->RemoveAllViewProps();
}

TEST(VtkResources, AVolumeLeavesAWindowThatIsNotCurrent)
{
  const Grid grid = tetrahedraOf(makeWavelet());
  Scene staying(grid, Side, Side), leaving(grid, Side, Side);
  prepare(staying);
  prepare(leaving);
  staying.Window->Render();
  const Image before = staying.frame();
  leaving.Window->Render();
  staying.Window->MakeCurrent();
  leaving.Renderer->RemoveAllViewProps();
  staying.Window->Render();
  EXPECT_EQ(staying.frame().Rgba, before.Rgba);
  leaving.Window->Render();
  EXPECT_EQ(compare(leaving.frame(), Image(Side, Side), {}, 0.0, Channels::Rgb).Max, 0.0);
  EXPECT_EQ(leaving.Mapper->GetGPUMemoryBytes(), 0);
  EXPECT_GT(staying.Mapper->GetGPUMemoryBytes(), 0);
}

TEST(VtkResources, AnotherArray)
{
  const auto image = makeWavelet();
  vtkDataArray* values = image->GetPointData()->GetScalars();
  vtkNew<vtkDoubleArray> sines;
  sines->SetName("sin_RTData");
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    sines->InsertNextValue(100.0 * std::sin(0.02 * values->GetTuple1(i)));
  }
  image->GetPointData()->AddArray(sines);
  Scene scene(tetrahedraOf(image), Side, Side);
  prepare(scene);
  const auto rival = makeImageMapper(image, 0.02);
  scene.Mapper->SetScalarModeToUsePointFieldData();
  rival->SetScalarModeToUsePointFieldData();
  for (const char* name : { "sin_RTData", "RTData" })
  {
    scene.Mapper->SelectScalarArray(name);
    rival->SelectScalarArray(name);
    scene.render();
    expectReference(scene.Mapper, scene.Volume, Side, Side);
    expectLike(scene, rival, 2.5, name);
  }
  EXPECT_EQ(scene.Mapper->GetMeshBuilds(), 1);
}

// A source is exchanged for one of other size and place.
TEST(VtkResources, AnotherSource)
{
  const auto shell = makeShell(), wavelet = makeWavelet(8);
  const Grid grids[] = { tetrahedraOf(shell), tetrahedraOf(wavelet) };
  Scene scene(grids[0], Side, Side);
  for (const int which : { 0, 1, 0 })
  {
    vtkNew<vtkTrivialProducer> source;
    source->SetOutput(grids[which]);
    scene.Mapper->SetInputConnection(source->GetOutputPort());
    prepare(scene);
    scene.render();
    expectReference(scene.Mapper, scene.Volume, Side, Side);
    expectLike(scene, makeImageMapper(which == 0 ? shell : wavelet, 0.02), 3.0);
  }
}
} // namespace
