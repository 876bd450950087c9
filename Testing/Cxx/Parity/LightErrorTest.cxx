// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The error of light that is kept at vertices, or sampled at a few points of a ray, against light
// that is evaluated at every point of the ray.
#include "CpuReference.h"

#include "vtkDataArray.h"
#include "vtkLight.h"
#include "vtkPointData.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;
using tetmarch::LightAt;
using Settings = vtkTetMarchSettings;

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

// Light that is evaluated at every point, which takes most of the time of these tests: it is
// computed once, whatever ways to draw the scene are compared with it.
class ExactLight
{
public:
  explicit ExactLight(Scene& scene, int shadows = Settings::SHADOWS_AT_VERTICES)
    : Of(scene)
  {
    scene.Mapper->SetAccuracyLevelToAccurate();
    scene.Mapper->SetShadowMethod(shadows);
    scene.render();
    this->Exact = referenceOf(scene, {}, Precision::Double, LightAt::Points).Picture;
    this->Inside = regionsOf(scene).Inside;
  }

  Difference errorOfShadows(int method, const char* what) const
  {
    this->Of.Mapper->SetShadowMethod(method);
    const Difference difference = compare(this->Of.render(), this->Exact, this->Inside);
    std::cout << "[ MEASURED ] " << what << ": " << difference.text() << '\n';
    return difference;
  }

  // The errors that are promised of light kept at vertices and of light sampled along rays.
  void expectSmallErrors() const
  {
    EXPECT_LE(this->errorOfShadows(Settings::SHADOWS_AT_VERTICES, "at vertices").Rms, 4.0 / 255.0);
    EXPECT_LE(this->errorOfShadows(Settings::SHADOWS_ALONG_RAYS, "along rays").Rms, 1.5 / 255.0);
  }

  // Pixels keep the tolerance of light, beside that of the integral, which is small.
  void expectToleranceKept(int method = Settings::SHADOWS_AUTOMATIC) const
  {
    for (const double tolerance : { 8.0 / 255.0, 2.0 / 255.0 })
    {
      this->Of.Mapper->SetLightTolerance(tolerance);
      EXPECT_LE(this->errorOfShadows(method, "within a tolerance").Percentile999, tolerance);
    }
  }

private:
  Scene& Of;
  Image Exact;
  Mask Inside;
};

TEST(LightError, GolfBall)
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(TETMARCH_DATA_DIR "/golfball_small.vtu");
  reader->Update();
  reader->GetOutput()->GetPointData()->SetActiveScalars("vorticity_mag");
  Scene scene(reader->GetOutput(), 96, 96);
  setWakeFunctions(scene.property());
  scene.camera()->SetFocalPoint(0.7, 0.0, 0.0);
  scene.camera()->SetPosition(2.0, 1.5, 4.0);
  scene.camera()->SetViewUp(0.0, 1.0, 0.0);
  scene.Renderer->ResetCameraClippingRange();
  shine(scene, 3.0, 6.0, 4.0);
  const ExactLight exact(scene);
  exact.expectSmallErrors();
  exact.expectToleranceKept();
}

TEST(LightError, Lattice)
{
  Scene scene(jitteredLattice(12, 0.15, 1, sineField()), 96, 96);
  shine(scene, 3.0, 4.0, 1.5);
  const ExactLight exact(scene);
  exact.expectSmallErrors();
  exact.expectToleranceKept();
}

// Cells of an optical depth of 2, in which light fades faster than a line between vertices or
// samples can tell. Nothing is promised, but the error bound of the frame says so where it is.
TEST(LightError, ThickCellsAreToldOfByTheErrorBound)
{
  Scene scene(jitteredLattice(12, 0.15, 1, sineField()), 96, 96);
  scene.property()->SetScalarOpacityUnitDistance(0.04);
  shine(scene, 3.0, 4.0, 1.5);
  scene.Mapper->SetShadowMethodToAtVertices();
  const Image drawn = scene.render();
  const Image exact = referenceOf(scene, {}, Precision::Double, LightAt::Points).Picture;
  const std::vector<float> bounds = referenceOf(scene).ErrorBounds;
  int wrong = 0;
  int told = 0;
  for (int y = 0; y < drawn.Height; ++y)
  {
    for (int x = 0; x < drawn.Width; ++x)
    {
      double most = 0.0;
      for (int k = 0; k < 4; ++k)
      {
        const double difference = double(drawn.pixel(x, y)[k]) - double(exact.pixel(x, y)[k]);
        most = std::max(most, std::abs(difference));
      }
      const bool isWrong = most > 8.0 / 255.0;
      const double bound = double(bounds[std::size_t(y) * drawn.Width + x]);
      wrong += isWrong ? 1 : 0;
      told += isWrong && bound >= most ? 1 : 0;
    }
  }
  std::cout << "[ MEASURED ] off by more than 8/255: " << wrong
            << " pixels, of which the bound tells " << told << '\n';
  EXPECT_GT(wrong, 100);
  EXPECT_GE(20 * told, 19 * wrong);
}

TEST(LightError, PointLightInside)
{
  Scene scene(jitteredLattice(16, 0.15, 1, sineField()), 96, 96);
  shine(scene, 0.45, 0.6, 0.5, true);
  const ExactLight exact(scene);
  exact.expectSmallErrors();
  exact.expectToleranceKept();
}

TEST(LightError, Tunnel)
{
  Scene scene(latticeWithTunnel(12, 0.15, 1, sineField()), 96, 96);
  shine(scene, 3.0, 4.0, 1.5);
  const ExactLight exact(scene);
  exact.expectSmallErrors();
  exact.expectToleranceKept();
}

// The shadow of a wire that is narrower than a cell of the wall, and falls through fog.
TEST(LightError, WireOverAWallInFog)
{
  const Field field = [](double x, double, double z)
  { return z < 0.16 || std::hypot(x - 0.5, z - 0.55) < 0.03 ? 1.0 : 0.0; };
  Scene scene(jitteredLattice(24, 0.1, 1, field), 96, 96);
  vtkPiecewiseFunction* opacity = scene.property()->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(0.0, 0.02);
  opacity->AddPoint(1.0, 1.0);
  scene.property()->SetScalarOpacityUnitDistance(0.02);
  scene.Mapper->SetVolumetricScatteringBlending(1.0f);
  shine(scene, 0.9, 0.7, 2.0);
  ExactLight(scene).expectToleranceKept();
}

TEST(LightError, Occlusion)
{
  Scene scene(jitteredLattice(12, 0.15, 1, sineField()), 48, 48);
  shine(scene, 3.0, 4.0, 1.5);
  scene.property()->SetAmbient(0.8);
  scene.Mapper->AmbientOcclusionOn();
  scene.Mapper->SetAmbientOcclusionRadius(0.2);
  const ExactLight exact(scene, Settings::SHADOWS_OFF);
  EXPECT_LE(exact.errorOfShadows(Settings::SHADOWS_OFF, "occlusion").Rms, 4.0 / 255.0);
  exact.expectToleranceKept(Settings::SHADOWS_OFF);
}
} // namespace
