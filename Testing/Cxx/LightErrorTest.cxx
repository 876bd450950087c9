// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How far light that is kept at vertices, or looked for at a few points of a ray, is from light
// looked for by brute force wherever a ray crosses a face.
#include "Twin.h"

#include "vtkDataArray.h"
#include "vtkLight.h"
#include "vtkPointData.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

void shine(Scene& scene, double x, double y, double z, bool positional = false)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(scene.camera()->GetFocalPoint());
  light->SetPositional(positional);
  light->SetConeAngle(180.0);
  scene.Renderer->AddLight(light);
  scene.property()->ShadeOn();
  scene.property()->SetAmbient(0.2);
  scene.property()->SetDiffuse(0.8);
  scene.property()->SetSpecular(0.3);
}

double errorOf(Scene& scene, const char* what)
{
  const Image drawn = scene.render();
  const Image exact = twinOf(scene, {}, Precision::Double, LightFrom::Everywhere).Picture;
  const Difference difference = compare(drawn, exact, regionsOf(scene).Inside);
  std::cout << "[ MEASURED ] " << what << ": " << difference.text() << '\n';
  return difference.Rms;
}

void expectErrors(Scene& scene)
{
  scene.Mapper->SetShadowMethodToAtVertices();
  EXPECT_LE(errorOf(scene, "at vertices"), 4.0 / 255.0);
  scene.Mapper->SetShadowMethodToAlongRays();
  EXPECT_LE(errorOf(scene, "along rays"), 1.5 / 255.0);
}

TEST(LightError, GolfBall)
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(TETMARCH_DATA_DIR "/golfball_small.vtu");
  reader->Update();
  reader->GetOutput()->GetPointData()->SetActiveScalars("vorticity_mag");
  Scene scene(reader->GetOutput());
  setWakeFunctions(scene.property());
  scene.camera()->SetFocalPoint(0.7, 0.0, 0.0);
  scene.camera()->SetPosition(2.0, 1.5, 4.0);
  scene.camera()->SetViewUp(0.0, 1.0, 0.0);
  scene.Renderer->ResetCameraClippingRange();
  shine(scene, 3.0, 6.0, 4.0);
  expectErrors(scene);
}

TEST(LightError, Lattice)
{
  Scene scene(jitteredLattice(12, 0.15, 1, sineField()));
  shine(scene, 3.0, 4.0, 1.5);
  expectErrors(scene);
}

TEST(LightError, ThickLattice)
{
  Scene scene(jitteredLattice(16, 0.15, 1, sineField()));
  scene.property()->SetScalarOpacityUnitDistance(0.03);
  shine(scene, 3.0, 4.0, 1.5);
  expectErrors(scene);
}

TEST(LightError, LampInside)
{
  Scene scene(jitteredLattice(16, 0.15, 1, sineField()));
  shine(scene, 0.45, 0.6, 0.5, true);
  expectErrors(scene);
}

TEST(LightError, Tunnel)
{
  Scene scene(latticeWithTunnel(12, 0.15, 1, sineField()));
  shine(scene, 3.0, 4.0, 1.5);
  expectErrors(scene);
}

TEST(LightError, Occlusion)
{
  Scene scene(jitteredLattice(12, 0.15, 1, sineField()));
  shine(scene, 3.0, 4.0, 1.5);
  scene.property()->SetAmbient(0.8);
  scene.Mapper->AmbientOcclusionOn();
  scene.Mapper->SetAmbientOcclusionRadius(0.2);
  EXPECT_LE(errorOf(scene, "occlusion"), 4.0 / 255.0);
}
} // namespace
