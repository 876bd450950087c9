// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws of a structured volume that is clipped or cropped, pixel by pixel against the
// CPU reference.
#include "StructuredScene.h"

#include "vtkActor.h"
#include "vtkPlane.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

void clip(StructuredScene& scene, const Vec3& origin, const Vec3& normal)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(origin[0], origin[1], origin[2]);
  plane->SetNormal(normal[0], normal[1], normal[2]);
  scene.Mapper->AddClippingPlane(plane);
}

// By planes within the unit cube, none of them in the middle.
void crop(StructuredScene& scene, int flags)
{
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(0.237, 0.711, 0.313, 0.564, 0.159, 0.823);
  scene.Mapper->SetCroppingRegionFlags(flags);
}

TEST(StructuredCuts, ClippedByPlanes)
{
  for (const LatticeValues values : AllLatticeValues)
  {
    StructuredScene scene(imageOf(sineField(), unitCube(9)));
    scene.draw(values);
    clip(scene, { 0.5, 0.45, 0.4 }, { -0.6, 0.3, -1.0 });
    const std::string what = nameOf(values);
    SCOPED_TRACE(what);
    report("one plane, " + what, expectParity(scene));
    clip(scene, { 0.5, 0.5, 0.45 }, { 0.7, 0.2, 0.5 });
    clip(scene, { 0.5, 0.5, 1.0 / 9.0 }, { 0.0, 0.0, 1.0 }); // a plane between cells
    report("three planes, " + what, expectParity(scene));
  }
}

// Each of the regions alone, and of some what is left without them.
TEST(StructuredCuts, TwentySevenRegions)
{
  StructuredScene image(imageOf(sineField(), unitCube(6)), 20, 20);
  StructuredScene grid(rectilinearOf(sineField(), unevenCube(6)), 20, 20);
  Worst worst;
  for (int region = 0; region < 27; ++region)
  {
    for (const bool alone : { true, false })
    {
      if (!alone && region % 4 != 1)
      {
        continue;
      }
      SCOPED_TRACE("region " + std::to_string(region) + (alone ? "" : " left out"));
      StructuredScene& scene = alone ? image : grid;
      crop(scene, alone ? 1 << region : 0x7ffffff & ~(1 << region));
      const Worst found = expectParity(scene);
      worst.Max = std::max(worst.Max, found.Max);
      worst.Rms = std::max(worst.Rms, found.Rms);
      worst.OverBound = std::max(worst.OverBound, found.OverBound);
    }
  }
  report("27 regions", worst);
}

TEST(StructuredCuts, CroppedAndClippedInLightAndWithOpaqueGeometry)
{
  StructuredScene scene(imageOf(sineField(), unitCube(9)));
  crop(scene, VTK_CROP_FENCE & ~0x1000); // one of the bars is left out
  clip(scene, { 0.5, 0.45, 0.4 }, { -0.6, 0.3, -1.0 });
  report("both", expectParity(scene));
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.5 }, 0.35, { 1.0, 1.0, 1.0 }));
  report("both, opaque geometry", expectParity(scene));
  setShading(scene.property());
  report("both, light", expectParity(scene, { true, false }));
  scene.Renderer->RemoveAllViewProps();
  scene.Renderer->AddVolume(scene.Volume);
  lookFromInside(scene.camera());
  scene.camera()->SetFocalPoint(0.2, 0.6, 0.1);
  report("both, camera inside", expectParity(scene, { true, false }));
}

TEST(StructuredCuts, ParallelAlongAnAxis)
{
  StructuredScene scene(imageOf(sineField(), unitCube(8)));
  clip(scene, { 0.5, 0.45, 0.4 }, { -0.6, 0.3, -1.0 });
  crop(scene, VTK_CROP_FENCE);
  lookDownZ(scene.camera(), 0.625);
  report("along an axis", expectParity(scene));
}

TEST(StructuredCuts, StretchedAndTurned)
{
  StructuredScene scene(imageOf(sineField(), unitCube(9)));
  clip(scene, { 0.5, 0.45, 0.4 }, { -0.6, 0.3, -1.0 });
  crop(scene, VTK_CROP_FENCE);
  vtkNew<vtkTransform> transform;
  transform->Translate(0.05, 0.1, 0.0);
  transform->RotateWXYZ(20.0, 1.0, 2.0, 3.0);
  transform->Scale(1.0, 0.7, -0.8);
  transform->Translate(-0.2, 0.1, -0.9);
  scene.Volume->SetUserTransform(transform);
  report("stretched and turned", expectParity(scene));
}

// Cut so that nearly all is gone, and what is left lies between blocks that are leapt over.
TEST(StructuredCuts, EmptySpace)
{
  StructuredScene scene(imageOf(sineField(1.5), unitCube(32)));
  setTwoPeaks(scene.property());
  scene.property()->SetScalarOpacityUnitDistance(0.05);
  crop(scene, VTK_CROP_FENCE);
  clip(scene, { 0.5, 0.45, 0.4 }, { -0.6, 0.3, -1.0 });
  report("empty space", expectParity(scene));
}
} // namespace
