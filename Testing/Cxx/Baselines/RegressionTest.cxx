// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whole pictures as users see them, against baselines under Testing/Data/Baseline. With
// TETMARCH_WRITE_BASELINES set they are written instead: look at each before you commit it.
#include "Scene.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkPNGReader.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 200;

Image readPng(const std::string& fileName)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  int size[3];
  reader->GetOutput()->GetDimensions(size);
  vtkDataArray* bytes = reader->GetOutput()->GetPointData()->GetScalars();
  Image image(size[0], size[1]);
  for (vtkIdType i = 0; bytes && i < bytes->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      image.Rgba[4 * i + k] = static_cast<float>(bytes->GetComponent(i, k) / 255.0);
    }
  }
  return image;
}

// Rounding may differ between GL drivers by a byte or two, edges of opaque geometry in a few
// pixels.
void expectBaseline(Scene& scene, const std::string& name)
{
  const std::string fileName = TETMARCH_BASELINE_DIR "/" + name + ".png";
  scene.Window->Render();
  const Image frame = scene.frame();
  if (std::getenv("TETMARCH_WRITE_BASELINES"))
  {
    ASSERT_TRUE(writePng(frame, fileName)) << fileName;
    return;
  }
  const Image baseline = readPng(fileName);
  ASSERT_EQ(baseline.Width, Side) << fileName;
  const Difference difference = compare(frame, baseline, {}, 2.5 / 255.0, Channels::Rgb);
  EXPECT_LE(difference.Over, 20u) << difference.text();
  EXPECT_LE(difference.Rms, 0.7 / 255.0) << difference.text();
  std::cout << "[ MEASURED ] " << difference.text() << '\n';
  if (testing::Test::HasFailure())
  {
    const std::string drawn = testing::TempDir() + name;
    writePng(frame, drawn + ".png");
    writePng(differenceImage(frame, baseline, 16.0f), drawn + "-difference.png");
    std::cout << "[ DRAWN    ] " << drawn << ".png, " << drawn << "-difference.png\n";
  }
}

TEST(Baseline, GolfBall)
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(TETMARCH_DATA_DIR "/golfball_small.vtu");
  reader->Update();
  reader->GetOutput()->GetPointData()->SetActiveScalars("vorticity_mag");
  Scene scene(reader->GetOutput(), Side, Side);
  setWakeFunctions(scene.property());
  scene.Renderer->SetBackground(0.02, 0.02, 0.04);
  scene.Renderer->AddActor(makeBall({ 0.0, 0.0, 0.0 }, 0.48, { 0.9, 0.9, 0.9 }));
  scene.camera()->SetPosition(2.0, 2.0, 6.5);
  scene.camera()->SetFocalPoint(1.3, 0.0, 0.0);
  scene.camera()->SetViewUp(0.0, 1.0, 0.0);
  scene.Renderer->ResetCameraClippingRange();
  expectBaseline(scene, "golfball");
}

TEST(Baseline, MixedCellsOverAGradient)
{
  Scene scene(mixedCells(6, 1, 0.1, sineField()), Side, Side);
  scene.Renderer->GradientBackgroundOn();
  scene.Renderer->SetBackground(0.9, 0.9, 0.8);
  scene.Renderer->SetBackground2(0.3, 0.4, 0.6);
  expectBaseline(scene, "mixed_cells");
}

TEST(Baseline, TunnelOfCellScalars)
{
  Scene scene(latticeWithTunnel(9, 0.15, 1, noiseField(1, 6)), Side, Side);
  scene.drawCellScalars();
  scene.property()->SetScalarOpacityUnitDistance(0.1);
  scene.camera()->SetPosition(0.9, 0.8, 3.2);
  expectBaseline(scene, "tunnel_cell_scalars");
}

TEST(Baseline, SpikesAroundAHole)
{
  Scene scene(latticeWithHole(15, 0.15, 1, radialField()), Side, Side);
  setSpikyFunctions(scene.property());
  scene.property()->SetScalarOpacityUnitDistance(0.01);
  scene.Renderer->SetBackground(1.0, 1.0, 1.0);
  expectBaseline(scene, "hole_spikes");
}

TEST(Baseline, OpaqueGeometryInside)
{
  Scene scene(jitteredLattice(10, 0.15, 1, sineField()), Side, Side);
  scene.property()->SetScalarOpacityUnitDistance(0.5);
  scene.Renderer->SetBackground(0.2, 0.2, 0.25);
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 1.0, 1.0 }));
  scene.Renderer->AddActor(makePlane(0.3, 0.3, { 0.6, 0.4, 0.2 }));
  expectBaseline(scene, "opaque_inside");
}

TEST(Baseline, CameraInside)
{
  Scene scene(jitteredLattice(10, 0.15, 1, sineField()), Side, Side);
  scene.camera()->SetPosition(0.31, 0.42, 0.57);
  scene.camera()->SetFocalPoint(1.0, 0.6, 0.4);
  scene.camera()->SetClippingRange(0.01, 5.0);
  scene.camera()->SetViewAngle(70.0);
  scene.property()->SetScalarOpacityUnitDistance(0.8);
  expectBaseline(scene, "camera_inside");
}
} // namespace
