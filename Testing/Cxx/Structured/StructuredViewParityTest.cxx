// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws of structured volumes along axes, in planes between cells and in every kind of
// window, pixel by pixel against the CPU reference.
#include "StructuredScene.h"

#include "vtkActor.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

vtkSmartPointer<vtkImageData> image(int n = 10) { return imageOf(sineField(), unitCube(n)); }

// Rays along each axis, 1/32 apart: within cells and, shifted by half of that, every fourth one in
// a plane between cells. The picture ends before the sides of the cube. Scalars without jumps are
// the same on either side of a plane.
TEST(StructuredView, AlongAxesAndInPlanesOfCells)
{
  const double directions[][3] = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 },
    { 0, 0, 1 }, { 0, 0, -1 }, { 1, 1, 0 }, { 0, -1, 1 } };
  for (const auto& d : directions)
  {
    for (const double shift : { 0.0, 1.0 / 64.0 })
    {
      StructuredScene scene(image(8), 28, 28);
      scene.camera()->ParallelProjectionOn();
      scene.camera()->SetParallelScale(0.4375);
      scene.property()->SetScalarOpacityUnitDistance(0.6);
      const bool upright = d[2] == 0.0;
      const double up[3] = { 0.0, upright ? 0.0 : 1.0, upright ? 1.0 : d[1] != 0.0 ? 1.0 : 0.0 };
      const double x = d[0] == 0.0 ? shift : 0.0;
      const double y = d[1] == 0.0 ? shift : 0.0;
      const double z = d[2] == 0.0 ? shift : 0.0;
      scene.camera()->SetFocalPoint(0.5 + x, 0.5 + y, 0.5 + z);
      scene.camera()->SetPosition(0.5 + x - 3 * d[0], 0.5 + y - 3 * d[1], 0.5 + z - 3 * d[2]);
      scene.camera()->SetViewUp(up);
      const std::string what = "along " + std::to_string(int(d[0])) + ' ' +
                               std::to_string(int(d[1])) + ' ' + std::to_string(int(d[2])) +
                               (shift == 0.0 ? "" : ", shifted");
      SCOPED_TRACE(what);
      report(what, expectParity(scene));
    }
  }
}

// In perspective the middle ray alone is along the axis; those of its row and column lie in planes.
TEST(StructuredView, PerspectiveInPlanesOfCells)
{
  StructuredScene scene(image(8), 25, 25);
  for (const LatticeValues values : { LatticeValues::PointsLinear, LatticeValues::CellsLinear })
  {
    scene.draw(values);
    scene.camera()->SetPosition(0.5, 0.5, 3.0);
    scene.camera()->SetFocalPoint(0.5, 0.5, 0.5);
    scene.camera()->SetViewUp(0.0, 1.0, 0.0);
    report(std::string("from the front, ") + nameOf(values), expectParity(scene));
    scene.camera()->SetPosition(2.5, 2.5, 2.5);
    report(std::string("along a diagonal, ") + nameOf(values), expectParity(scene));
    scene.camera()->SetPosition(0.5, 0.5, 0.5); // in a point of the lattice
    scene.camera()->SetFocalPoint(1.0, 0.5, 0.5);
    scene.camera()->SetClippingRange(0.01, 5.0);
    report(std::string("from a point of the lattice, ") + nameOf(values), expectParity(scene));
  }
}

TEST(StructuredView, CameraInside)
{
  for (const bool parallel : { false, true })
  {
    for (const LatticeValues values : AllLatticeValues)
    {
      StructuredScene scene(image());
      scene.draw(values);
      lookFromInside(scene.camera());
      scene.camera()->SetParallelProjection(parallel);
      scene.camera()->SetParallelScale(0.4);
      scene.property()->SetScalarOpacityUnitDistance(0.6);
      report(std::string("inside, ") + nameOf(values), expectParity(scene));
    }
  }
  StructuredScene empty(imageOf(sineField(1.5), unitCube(32)));
  setTwoPeaks(empty.property());
  lookFromInside(empty.camera());
  report("inside, empty space", expectParity(empty));
}

TEST(StructuredView, NearPlaneVeryNear)
{
  StructuredScene scene(image());
  for (const bool parallel : { false, true })
  {
    scene.camera()->SetParallelProjection(parallel);
    scene.camera()->SetClippingRange(0.5, 10.0);
    const Image fitting = scene.render();
    scene.camera()->SetClippingRange(parallel ? -1e8 : 1e-6, parallel ? 1e8 : 1000.0);
    const auto ball = makeBall({ 0.5, -0.5, 0.5 }, 0.1, { 1.0, 1.0, 1.0 }); // hides nothing
    for (int i = 0; i < 2; ++i)
    {
      const Difference difference = compare(scene.render(), fitting);
      EXPECT_LE(difference.Max, 2.0 / 255.0) << difference.text();
      scene.Renderer->AddActor(ball);
    }
    scene.Renderer->RemoveActor(ball);
  }
}

TEST(StructuredView, OblongAndTinyWindows)
{
  StructuredScene oblong(image(), 60, 25);
  report("oblong", expectParity(oblong));
  StructuredScene pixel(image(), 1, 1);
  report("a single pixel", expectParity(pixel));
}

TEST(StructuredView, TwoRenderers)
{
  StructuredScene scene(image(), 2 * StructuredSize, StructuredSize);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.0, 0.0, 0.5, 1.0);
  other->AddVolume(scene.Volume);
  lookFromInside(other->GetActiveCamera());
  scene.Window->AddRenderer(other);
  scene.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  scene.Window->Render();
  const Image both = scene.frame();
  scene.Window->RemoveRenderer(other);
  report("in a viewport", expectParity(scene));
  // The other one alone, in the place of this one.
  scene.Mapper->SetAccuracyLevelToDefault();
  for (const bool left : { true, false })
  {
    scene.camera()->DeepCopy(other->GetActiveCamera());
    if (!left)
    {
      lookAtUnitCube(scene.camera());
    }
    scene.Renderer->SetViewport(left ? 0.0 : 0.5, 0.0, left ? 0.5 : 1.0, 1.0);
    scene.Window->Render();
    const int x = left ? 0 : StructuredSize;
    const Difference difference =
      compare(cropped(scene.frame(), x, 0, StructuredSize, StructuredSize),
        cropped(both, x, 0, StructuredSize, StructuredSize), {}, 0.0, Channels::Rgb);
    EXPECT_LE(difference.Max, 1.0 / 255.0) << left << ": " << difference.text();
  }
}
} // namespace
