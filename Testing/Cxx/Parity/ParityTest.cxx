// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws of every kind of mesh, pixel by pixel against the CPU reference.
#include "CpuReference.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch::testing;

void lookAtAll(Scene& scene, double azimuth = 35.0, double elevation = 20.0)
{
  scene.Renderer->ResetCamera();
  scene.camera()->Azimuth(azimuth);
  scene.camera()->Elevation(elevation);
  scene.camera()->Roll(7.0);
  scene.Renderer->ResetCamera();
  scene.camera()->Zoom(1.4);
}

TEST(Parity, JitteredLattice)
{
  Scene scene(jitteredLattice(12, 0.15, 1, sineField()));
  expectParity(scene);
}

TEST(Parity, NoiseInManyCells)
{
  Scene scene(jitteredLattice(24, 0.15, 3, noiseField()));
  expectParity(scene);
}

TEST(Parity, GolfBall)
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(TETMARCH_DATA_DIR "/golfball_small.vtu");
  reader->Update();
  reader->GetOutput()->GetPointData()->SetActiveScalars("vorticity_mag");
  Scene scene(reader->GetOutput());
  setWakeFunctions(scene.property());
  scene.camera()->SetPosition(3.0, 4.5, 9.0);
  scene.camera()->SetFocalPoint(1.5, 0.0, 0.0);
  scene.camera()->SetViewUp(0.0, 1.0, 0.0);
  scene.Renderer->ResetCameraClippingRange();
  expectParity(scene);
}

TEST(Parity, MixedCells)
{
  Scene scene(mixedCells(6, 1, 0.1, sineField()));
  expectParity(scene);
}

TEST(Parity, QuadraticCells)
{
  Scene scene(quadraticTetLattice(3, 0.1, sineField()));
  expectParity(scene);
}

TEST(Parity, Hole)
{
  Scene scene(latticeWithHole(9, 0.15, 1, sineField()));
  expectParity(scene);
}

TEST(Parity, Tunnel)
{
  Scene scene(latticeWithTunnel(9, 0.15, 1, sineField()));
  scene.camera()->SetPosition(0.9, 0.8, 3.2);
  expectParity(scene);
}

TEST(Parity, TwoComponents)
{
  Scene scene(twoComponents(6, 0.15, 1, sineField()));
  lookAtAll(scene, 75.0);
  expectParity(scene);
}

TEST(Parity, NestedShells)
{
  Scene scene(nestedShells(12, 4, 0.15, 1, sineField()));
  expectParity(scene);
}

TEST(Parity, HangingNodes)
{
  Scene scene(refinedCubes(8, 8, 1, sineField()));
  expectParity(scene);
}

TEST(Parity, CellScalars)
{
  Scene scene(jitteredLattice(10, 0.15, 1, noiseField()));
  scene.drawCellScalars();
  expectParity(scene);
}

TEST(Parity, CellScalarsOfMixedCells)
{
  Scene scene(mixedCells(6, 2, 0.1, noiseField()));
  scene.drawCellScalars();
  expectParity(scene);
}

TEST(Parity, ScalarsThatAreNotFinite)
{
  const Grid grid = jitteredLattice(10, 0.15, 1, sineField());
  vtkDataArray* scalars = grid->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); i += 37)
  {
    scalars->SetComponent(i, 0,
      i % 2 ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity());
  }
  Scene scene(grid);
  expectParity(scene);
}

TEST(Parity, CellsInAnyOrderAndOrientation)
{
  Scene scene(shuffled(jitteredLattice(10, 0.15, 1, sineField())));
  expectParity(scene);
}

TEST(Parity, FarFromTheOrigin)
{
  const Vec3 offset{ 1e5, -2e5, 3e5 };
  Scene scene(withOffsetAndScale(jitteredLattice(10, 0.15, 1, sineField()), offset, 1.0));
  scene.camera()->SetFocalPoint(0.5 + offset[0], 0.45 + offset[1], 0.5 + offset[2]);
  scene.camera()->SetPosition(2.1 + offset[0], 1.4 + offset[1], 2.9 + offset[2]);
  expectParity(scene);
}

TEST(Parity, Thick)
{
  Scene scene(jitteredLattice(10, 0.15, 1, sineField()));
  scene.property()->SetScalarOpacityUnitDistance(0.001);
  expectParity(scene);
}

// Optical depths beyond the range of float: opaque, and no NaN (compare() takes one for an infinite
// difference).
TEST(Parity, ThickerThanFloatsTell)
{
  Scene scene(jitteredLattice(4, 0.15, 1, constantField(0.5)));
  scene.property()->SetScalarOpacityUnitDistance(1e-9);
  const Image opaque = scene.render();
  scene.property()->SetScalarOpacityUnitDistance(1e-200);
  EXPECT_LE(compare(scene.render(), opaque).Max, 1.0 / 255.0);
}

TEST(Parity, Thin)
{
  Scene scene(jitteredLattice(10, 0.15, 1, sineField()));
  scene.property()->SetScalarOpacityUnitDistance(20.0);
  expectParity(scene);
}

TEST(Parity, NarrowSpikes)
{
  Scene scene(jitteredLattice(10, 0.15, 1, sineField()));
  setSpikyFunctions(scene.property());
  scene.property()->SetScalarOpacityUnitDistance(0.01);
  expectParity(scene);
}

// The shader variant for one colour, which looks no colours up.
TEST(Parity, OneColour)
{
  Scene scene(jitteredLattice(10, 0.15, 1, sineField()));
  scene.property()->GetRGBTransferFunction()->RemoveAllPoints();
  scene.property()->GetRGBTransferFunction()->AddRGBPoint(0.0, 0.9, 0.5, 0.1);
  expectParity(scene);
  scene.drawCellScalars();
  expectParity(scene);
}

// The shader variant that steps through transparent cells.
TEST(Parity, TransparentRanges)
{
  Scene scene(jitteredLattice(10, 0.15, 1, sineField()));
  setTwoPeaks(scene.property());
  expectParity(scene);
  scene.drawCellScalars();
  expectParity(scene);
}

TEST(Parity, StructuredLawAndGray)
{
  Scene scene(jitteredLattice(10, 0.15, 1, sineField()));
  scene.Mapper->SetOpacityLawToStructured();
  vtkNew<vtkPiecewiseFunction> gray;
  gray->AddPoint(0.0, 0.0);
  gray->AddPoint(0.7, 1.0);
  scene.property()->SetColor(gray);
  expectParity(scene);
}
} // namespace
