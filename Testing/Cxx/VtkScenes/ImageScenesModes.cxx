// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes of VTK's tests about blend modes, cuts, cameras and light.
#include "ImageScene.h"

#include "VtkScene.h"

#include "vtkContourValues.h"
#include "vtkPlane.h"

namespace tetmarch::testing
{
namespace
{
using Data = vtkSmartPointer<vtkDataSet>;

Data wavelet() { return makeWavelet(); }
Data shell() { return makeShell(); }

void waveletFunctions(ImageStage& stage) { setFunctions(stage.Property, 40.0, 280.0, 0.15); }
void shellFunctions(ImageStage& stage) { setFunctions(stage.Property, 50.0, 255.0, 0.4); }

// Cropping planes about the middle, each moved outwards by a distance.
std::function<void(ImageStage&)> cropped(int flags, double outwards)
{
  return [=](ImageStage& stage)
  {
    shellFunctions(stage);
    stage.Mapper->CroppingOn();
    stage.Mapper->SetCroppingRegionPlanes(6.3 - outwards, 12.7 + outwards, 7.1 - outwards,
      13.4 + outwards, 6.6 - outwards, 12.2 + outwards);
    stage.Mapper->SetCroppingRegionFlags(flags);
  };
}

// Colours of the values that VTK's tests of surfaces and slices have.
void surfaceFunctions(ImageStage& stage)
{
  vtkNew<vtkColorTransferFunction> colours;
  colours->AddRGBPoint(150.0, 1.0, 1.0, 1.0);
  colours->AddRGBPoint(190.0, 0.0, 1.0, 1.0);
  colours->AddRGBPoint(220.0, 0.0, 1.0, 0.0);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(150.0, 0.2);
  opacities->AddPoint(190.0, 0.6);
  opacities->AddPoint(220.0, 1.0);
  stage.Property->SetColor(colours);
  stage.Property->SetScalarOpacity(opacities);
  stage.Property->SetInterpolationTypeToLinear();
}

std::function<void(ImageStage&)> inMode(int mode)
{
  return [mode](ImageStage& stage)
  {
    setFunctions(stage.Property, 40.0, 280.0, 0.8);
    stage.Property->SetScalarOpacityUnitDistance(8.0);
    stage.Mapper->SetBlendMode(mode);
    stage.Mapper->SetAverageIPScalarRange(100.0, 220.0);
  };
}

std::function<void(ImageStage&)> fromWithin(const Vec3& from, const Vec3& at, double angle)
{
  return [=](ImageStage& stage)
  {
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    camera->SetPosition(from.data());
    camera->SetFocalPoint(at.data());
    camera->SetViewAngle(angle);
    camera->SetClippingRange(0.01, 60.0);
  };
}

void inLight(ImageStage& stage)
{
  stage.Property->ShadeOn();
  stage.Property->SetAmbient(0.2);
  stage.Property->SetDiffuse(0.8);
  stage.Property->SetSpecular(0.0); // before VTK 9.2 not as ours
}
} // namespace

std::vector<ImageScene> imageModeScenes()
{
  // Ours, not VTK's: single pixels, up to 22/255.
  const RivalError crest = { 2.5,
    "ours has dark speckles on the crest of a shell, where gradients turn" };
  const RivalError steps = { 2.0, "its steps miss the ends of short ways" };
  std::vector<ImageScene> scenes = {
    { "GPURayCastMIP", wavelet, inMode(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND), {} },
    { "GPURayCastMinIP", wavelet, inMode(vtkVolumeMapper::MINIMUM_INTENSITY_BLEND), {} },
    { "GPURayCastAdditive", wavelet, inMode(vtkVolumeMapper::ADDITIVE_BLEND), {} },
    { "GPURayCastAverageIP", wavelet, inMode(vtkVolumeMapper::AVERAGE_INTENSITY_BLEND), {} },
    { "GPURayCastIsosurface", wavelet,
      [](ImageStage& stage)
      {
        surfaceFunctions(stage);
        stage.Mapper->SetBlendModeToIsoSurface();
        stage.Property->GetIsoSurfaceValues()->SetValue(0, 220.0);
        stage.Property->GetIsoSurfaceValues()->SetValue(1, 150.0);
        stage.Property->GetIsoSurfaceValues()->SetValue(2, 190.0);
      },
      { 4.5, "its steps miss surfaces next to the ends of a way" } },
    { "GPURayCastSlicePlane", wavelet,
      [](ImageStage& stage)
      {
        surfaceFunctions(stage);
        stage.Mapper->SetBlendModeToSlice();
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(1.0, 0.0, 0.0);
        plane->SetNormal(0.707107, 0.0, 0.707107);
        stage.Property->SetSliceFunction(plane);
      },
      { 15.0, "values of slices are up to half a voxel beside their place" }, {}, true,
      "VTK draws slices for it" },
    { "GPURayCastClipping", wavelet,
      [](ImageStage& stage)
      {
        waveletFunctions(stage);
        addPlane(stage, { -4.0, -3.0, 0.0 }, { 1.0, 0.2, 0.1 });
        addPlane(stage, { -4.0, -3.0, 0.0 }, { -0.3, 1.0, -0.2 });
      },
      {}, {}, true, "", 2.0 },
    { "GPURayCastCameraInside", wavelet, waveletFunctions, {},
      fromWithin({ 1.0, 2.0, 3.0 }, { 0.0, 1.0, -9.0 }, 60.0), true, "", 2.0 },
    { "GPURayCastCameraInside, wide", wavelet, waveletFunctions, {},
      fromWithin({ -5.0, 2.0, 8.0 }, { 0.0, 1.0, 0.0 }, 140.0) },
    { "GPURayCastPerspectiveParallel", wavelet, waveletFunctions, {},
      [](ImageStage& stage)
      {
        vtkCamera* camera = stage.Renderer->GetActiveCamera();
        camera->ParallelProjectionOn();
        camera->Azimuth(20.0);
        camera->Elevation(15.0);
        stage.Renderer->ResetCamera();
        camera->Zoom(1.4);
      } },
    { "GPURayCastPerspectiveParallel, along an axis", wavelet, waveletFunctions, {},
      [](ImageStage& stage)
      {
        stage.Renderer->GetActiveCamera()->ParallelProjectionOn();
        stage.Renderer->ResetCamera();
        stage.Renderer->GetActiveCamera()->Zoom(1.4);
      } },
    { "GPURayCastShaded", shell,
      [](ImageStage& stage)
      {
        shellFunctions(stage);
        inLight(stage);
      },
      crest, {}, false },
    { "GPURayCastGradientOpacity", shell,
      [](ImageStage& stage)
      {
        shellFunctions(stage);
        vtkNew<vtkPiecewiseFunction> gradient;
        gradient->AddPoint(0.0, 0.0);
        gradient->AddPoint(60.0, 1.0);
        stage.Property->SetGradientOpacity(gradient);
      },
      crest, {}, false },
    { "GPURayCastGradientOpacityLight", shell,
      [](ImageStage& stage)
      {
        shellFunctions(stage);
        inLight(stage);
        vtkNew<vtkPiecewiseFunction> gradient;
        gradient->AddPoint(0.0, 0.0);
        gradient->AddPoint(60.0, 1.0);
        stage.Property->SetGradientOpacity(gradient);
      },
      crest, {}, false },
  };
  const struct
  {
    const char* What;
    int Flags;
    double Outwards;
  } cropping[] = { { "subvolume", VTK_CROP_SUBVOLUME, 2.0 }, { "fence", VTK_CROP_FENCE, 0.0 },
    { "inverted fence", VTK_CROP_INVERTED_FENCE, 0.0 }, { "cross", VTK_CROP_CROSS, 0.0 },
    { "inverted cross", VTK_CROP_INVERTED_CROSS, 0.0 }, { "four regions", 24600, 0.0 },
    { "a corner", 1, -2.4 }, { "scattered regions", 67117057, 0.0 } };
  for (const auto& of : cropping)
  {
    scenes.push_back(
      { std::string("GPURayCastCropping, ") + of.What, shell, cropped(of.Flags, of.Outwards), steps,
        {}, true, "", of.Flags == VTK_CROP_FENCE ? 3.0 : 6.0 });
  }
  return scenes;
}
} // namespace tetmarch::testing
