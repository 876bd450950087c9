// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws of a volume that is clipped or cropped, in every kind of scene, pixel by pixel
// against the CPU reference.
#include "CpuReference.h"
#include "CutScene.h"

#include "vtkActor.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 96;

Grid lattice() { return jitteredLattice(10, 0.15, 1, sineField()); }

enum class Cut
{
  Clipped,
  Cropped,
  Both
};

class ClippingParity : public ::testing::TestWithParam<Cut>
{
protected:
  void cut(Scene& scene)
  {
    if (this->GetParam() != Cut::Cropped)
    {
      clipObliquely(scene);
    }
    if (this->GetParam() != Cut::Clipped)
    {
      crop(scene, VTK_CROP_FENCE & ~0x1000); // one of the bars is left out
    }
  }
};

TEST_P(ClippingParity, AtEveryLevel)
{
  Scene scene(lattice(), Side, Side);
  this->cut(scene);
  for (int level = vtkTetMarchVolumeMapper::FAST; level <= vtkTetMarchVolumeMapper::REFERENCE;
       ++level)
  {
    scene.Mapper->SetAccuracyLevel(level);
    SCOPED_TRACE(scene.Mapper->GetAccuracyLevelAsString());
    expectParity(scene);
  }
}

TEST_P(ClippingParity, TransparentRangesAndOneColour)
{
  Scene scene(lattice(), Side, Side);
  this->cut(scene);
  setSpikyFunctions(scene.property());
  expectParity(scene);
  setPlainFunctions(scene.property(), { 0.9, 0.5, 0.2 }, 0.4);
  expectParity(scene);
}

TEST_P(ClippingParity, OpaqueGeometry)
{
  Scene scene(lattice(), Side, Side);
  this->cut(scene);
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.5 }, 0.35, { 1.0, 1.0, 1.0 }));
  scene.Renderer->AddActor(makePlane(0.2, 0.4, { 0.0, 0.0, 0.0 }));
  expectParityWithOpaque(scene);
}

TEST_P(ClippingParity, MeshesWithHolesAndOfSeveralParts)
{
  for (const Grid& grid : { latticeWithHole(9, 0.15, 1, sineField()),
         latticeWithTunnel(9, 0.15, 1, sineField()), nestedShells(10, 4, 0.15, 1, sineField()) })
  {
    Scene scene(grid, Side, Side);
    this->cut(scene);
    expectParity(scene);
  }
}

TEST_P(ClippingParity, CameraInside)
{
  Scene scene(nestedShells(10, 4, 0.15, 1, sineField()), Side, Side);
  this->cut(scene);
  scene.camera()->SetPosition(0.81, 0.42, 0.87);
  scene.camera()->SetFocalPoint(0.2, 0.6, 0.1);
  scene.camera()->SetClippingRange(0.01, 5.0);
  expectParity(scene);
}

TEST_P(ClippingParity, ParallelAlongAnAxisOfALattice)
{
  Scene scene(jitteredLattice(8, 0.0, 1, sineField()), Side, Side);
  this->cut(scene);
  lookDownZ(scene.camera(), 0.625);
  expectParity(scene);
}

TEST_P(ClippingParity, StretchedVolumeFarFromTheOrigin)
{
  const double far = 1e6;
  Scene scene(withOffsetAndScale(lattice(), { far, -far, 2.0 * far }, 1.0), Side, Side);
  this->cut(scene);
  scene.Mapper->SetCroppingRegionPlanes(
    far + 0.237, far + 0.711, 0.313 - far, 0.564 - far, 2.0 * far + 0.159, 2.0 * far + 0.823);
  vtkNew<vtkTransform> transform;
  transform->Translate(0.05, 0.1, 0.0);
  transform->RotateWXYZ(20.0, 1.0, 2.0, 3.0);
  transform->Scale(1.0, 0.7, -0.8);
  transform->Translate(-0.2 - far, 0.1 + far, -0.9 - 2.0 * far);
  scene.Volume->SetUserTransform(transform);
  expectParity(scene);
}

INSTANTIATE_TEST_SUITE_P(Cuts, ClippingParity,
  ::testing::Values(Cut::Clipped, Cut::Cropped, Cut::Both),
  [](const auto& named)
  {
    return named.param == Cut::Clipped ? "Clipped"
                                       : (named.param == Cut::Cropped ? "Cropped" : "Both");
  });
} // namespace
