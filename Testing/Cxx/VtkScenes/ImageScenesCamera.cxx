// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes of VTK's tests about the place of the camera, of the volume and of planes that follow.
#include "ImageScene.h"

#include "VtkScene.h"

#include "vtkActor.h"
#include "vtkMatrix4x4.h"

#include <limits>

namespace tetmarch::testing
{
namespace
{
using Data = vtkSmartPointer<vtkDataSet>;
using Change = std::function<void(ImageStage&)>;

Data wavelet() { return makeWavelet(); }
Data shell() { return makeShell(); }
Data fineShell() { return makeShell(27); }

Change waveletOf(double greatest)
{
  return [greatest](ImageStage& stage) { setFunctions(stage.Property, 40.0, 280.0, greatest); };
}

void stretched(ImageStage& stage)
{
  waveletOf(0.1)(stage);
  vtkNew<vtkMatrix4x4> matrix;
  const double rows[16] = { 3.2, 0, 0, 20, 0, 3.2, 0, 10, 0, 0, 1.5, 4, 0, 0, 0, 1 };
  matrix->DeepCopy(rows);
  stage.Volume->PokeMatrix(matrix);
}

void turned(ImageStage& stage)
{
  waveletOf(0.3)(stage);
  stage.Volume->RotateX(180.0);
  stage.Volume->RotateY(85.0);
  stage.Volume->RotateZ(55.0);
  stage.Volume->SetOrigin(30.0, 2.0, 3.0);
}

// Colours on a sphere that ends within a hundredth of its value.
void sharp(ImageStage& stage)
{
  setFunctions(stage.Property, 0.0, 160.0, 0.5);
  stage.Property->GetScalarOpacity()->AddPoint(160.1, 0.0);
  stage.Property->GetScalarOpacity()->AddPoint(255.0, 0.0);
}

// A shell in light, opened to show a ball.
void opened(ImageStage& stage)
{
  setFunctions(stage.Property, 50.0, 255.0, 1.0);
  stage.Property->ShadeOn();
  stage.Property->SetAmbient(0.1);
  stage.Property->SetDiffuse(0.7);
  stage.Property->SetSpecular(0.0); // before VTK 9.2 not as ours
  const Vec3 centre{ 10.0, 10.0, 10.0 };
  stage.Renderer->AddActor(makeBall(centre, 4.0, { 1.0, 1.0, 1.0 }));
  addPlane(stage, centre, { -1.0, 0.0, 0.0 });
  addPlane(stage, centre, { -0.2, 0.2, 0.0 });
}

// The greatest value of a volume that stands upright.
void upright(ImageStage& stage)
{
  waveletOf(1.0)(stage);
  stage.Mapper->SetBlendModeToMaximumIntensity();
  vtkNew<vtkMatrix4x4> matrix;
  const double rows[16] = { 0, 0, -1, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, 1 };
  matrix->DeepCopy(rows);
  stage.Volume->SetUserMatrix(matrix);
}

vtkCamera* look(ImageStage& stage, const Vec3& from, const Vec3& at, const Vec3& up = { 0, 1, 0 })
{
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(from.data());
  camera->SetFocalPoint(at.data());
  camera->SetViewUp(up.data());
  stage.Renderer->ResetCameraClippingRange();
  return camera;
}

// On its way into the volume, through it and out again.
Change atHeight(double z)
{
  return [z](ImageStage& stage) { look(stage, { 0.3 * z, 0.2 * z, z }, { 1.0, 2.0, z - 12.0 }); };
}

// Corners before the near plane, with a wide angle, about a ball.
Change aboutABall(double near)
{
  return [near](ImageStage& stage)
  {
    stage.Renderer->AddActor(makeBall({ 3.0, -4.0, -2.0 }, 4.0, { 1.0, 1.0, 1.0 }));
    vtkCamera* camera = look(stage, { 0.0, 2.0, 13.0 }, { 0.0, 2.0, -3.0 });
    camera->SetViewAngle(110.0);
    camera->Elevation(-45.0);
    camera->OrthogonalizeViewUp();
    camera->Azimuth(34.9);
    camera->OrthogonalizeViewUp();
    camera->SetClippingRange(near, 60.0);
  };
}

void withinStretched(ImageStage& stage)
{
  const Vec3 up{ -0.105, 0.899, 0.424 };
  vtkCamera* camera = look(stage, { 25.7, 16.9, 3.9 }, { 17.8, 11.1, 14.2 }, up);
  camera->SetViewAngle(170.0);
  camera->SetClippingRange(0.01, 200.0);
}

Change fromBeside(const Vec3& away, double near)
{
  return [away, near](ImageStage& stage)
  {
    const double* c = stage.Volume->GetCenter();
    vtkCamera* camera =
      look(stage, { c[0] + away[0], c[1] + away[1], c[2] + away[2] }, { c[0], c[1], c[2] });
    camera->SetClippingRange(near, 100.0);
  };
}

Change ontoTheShell(bool parallel)
{
  return [parallel](ImageStage& stage)
  {
    look(stage, { 17.0, 23.0, 97.0 }, { 13.0, 13.0, 13.0 })->SetParallelProjection(parallel);
    stage.Renderer->ResetCamera();
  };
}

// Aslant onto the middle; planes of a slab about it follow the camera.
Change ontoTheSlab(double turn)
{
  return [turn](ImageStage& stage)
  {
    vtkCamera* camera = look(stage, { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 });
    camera->ParallelProjectionOn();
    stage.Renderer->ResetCamera();
    camera->SetParallelScale(15.0);
    camera->Azimuth(turn);
    camera->Elevation(0.5 * turn);
    camera->OrthogonalizeViewUp();
    stage.Renderer->ResetCameraClippingRange();
    const double* n = camera->GetViewPlaneNormal();
    addPlane(stage, { 1.5 * n[0], 1.5 * n[1], 1.5 * n[2] }, { -n[0], -n[1], -n[2] });
    addPlane(stage, { -1.5 * n[0], -1.5 * n[1], -1.5 * n[2] }, { n[0], n[1], n[2] });
  };
}

void ontoTheOpening(ImageStage& stage)
{
  stage.Renderer->ResetCamera();
  stage.Renderer->GetActiveCamera()->Azimuth(30.0);
  stage.Renderer->GetActiveCamera()->Elevation(-25.0);
  stage.Renderer->ResetCameraClippingRange();
}
} // namespace

std::vector<ImageScene> imageCameraScenes()
{
  const RivalError steps = { 2.5, "its steps are long next to the camera" };
  constexpr double NotLikeVtk = std::numeric_limits<double>::infinity();
  std::vector<ImageScene> scenes = {
    { "GPURayCastCameraInsideNonUniformScaleTransform", wavelet, stretched,
      { 20.0, "it is inaccurate at an angle of 170 degrees" }, withinStretched, true, "",
      NotLikeVtk },
    { "GPURayCastCameraInsideTransformation, before", wavelet, turned, {},
      fromBeside({ 20.0, 9.0, -31.0 }, 1.0), true, "", 2.5 },
    { "GPURayCastCameraInsideTransformation, inside", wavelet, turned, steps,
      fromBeside({ 3.0, 2.0, -4.0 }, 0.01), true, "", 2.5 },
    { "GPURayCastPerspectiveParallel, perspective", fineShell, sharp, {}, ontoTheShell(false), true,
      "", 5.0 },
    { "GPURayCastPerspectiveParallel, parallel", fineShell, sharp, {}, ontoTheShell(true), true, "",
      5.0 },
    { "GPURayCastClippingPolyData", shell, opened, { 6.0 }, ontoTheOpening, false, "", 6.0 },
  };
  for (const double z : { 30.0, 9.7, -4.0 })
  {
    scenes.push_back({ "GPURayCastCameraInside, at " + std::to_string(z), wavelet, waveletOf(0.3),
      steps, atHeight(z), true, "", 2.0 });
  }
  for (const double near : { 0.1, 2.0, 6.0 })
  {
    scenes.push_back({ "GPURayCastCameraInsideClipping, near plane at " + std::to_string(near),
      wavelet, waveletOf(0.3), { 3.0 }, aboutABall(near), false, "", 3.0 });
  }
  for (const double turn : { 0.0, 40.0 })
  {
    scenes.push_back({ "GPURayCastClippingUserTransform, turned by " + std::to_string(turn),
      wavelet, upright, {}, ontoTheSlab(turn), true, "", 4.0 });
  }
  return scenes;
}
} // namespace tetmarch::testing
