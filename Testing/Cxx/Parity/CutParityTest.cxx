// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws of a volume of each kind that is clipped or cropped, pixel by pixel against the
// CPU reference.
#include "CutScene.h"
#include "ParityScenes.h"

#include "vtkActor.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

template <typename Kind>
const Case<Kind> Cuts[] = {
  { "clipped",
    [](Kind& scene)
    {
      clipObliquely(scene);
      addClippingPlane(scene, { 0.5, 0.5, 0.45 }, { 0.7, 0.2, 0.5 });
      addClippingPlane(scene, { 0.5, 0.5, 1.0 / 8.0 }, { 0.0, 0.0, 1.0 }); // between cells
    } },
  { "cropped", [](Kind& scene) { crop(scene, VTK_CROP_FENCE & ~0x1000); } }, // a bar is left out
  { "clipped and cropped",
    [](Kind& scene)
    {
      clipObliquely(scene);
      crop(scene, VTK_CROP_FENCE & ~0x1000);
    } },
};

template <typename Kind>
const Case<Kind> Settings[] = {
  { "transparent ranges", [](Kind& scene) { scene.setTransparentRanges(); } },
  { "one colour",
    [](Kind& scene) {
      setPlainFunctions(scene.property(), { 0.9, 0.5, 0.2 }, 0.4);
    } },
  { "opaque geometry, then light",
    [](Kind& scene)
    {
      scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.5 }, 0.35, { 1.0, 1.0, 1.0 }));
      scene.Renderer->AddActor(makePlane(0.2, 0.4, { 0.0, 0.0, 0.0 }));
      scene.expectParity("without light");
      setShading(scene.property());
    } },
};

template <typename Kind>
class CutParity : public ::testing::Test
{
protected:
  static void expectParityOfCuts(Shape shape, const std::string& what, void (*change)(Kind& scene))
  {
    for (const Case<Kind>& cut : Cuts<Kind>)
    {
      Kind scene(shape);
      cut.Change(scene);
      change(scene);
      scene.expectParity(what + ", " + cut.Name);
    }
  }
};
TYPED_TEST_SUITE(CutParity, ParityKinds, ParityKindNames);

TYPED_TEST(CutParity, EachKindOfData)
{
  for (const Case<TypeParam>& cut : Cuts<TypeParam>)
  {
    TypeParam::forEach(
      [&](TypeParam& scene, const std::string& name)
      {
        cut.Change(scene);
        scene.expectParity(name + ", " + cut.Name);
      });
  }
}

TYPED_TEST(CutParity, EachSetting)
{
  for (const Case<TypeParam>& setting : Settings<TypeParam>)
  {
    this->expectParityOfCuts(Shape::Plain, setting.Name, setting.Change);
  }
}

TYPED_TEST(CutParity, CameraInside)
{
  this->expectParityOfCuts(Shape::Hard, "inside",
    [](TypeParam& scene)
    {
      scene.camera()->SetPosition(0.81, 0.42, 0.87);
      scene.camera()->SetFocalPoint(0.2, 0.6, 0.1);
      scene.camera()->SetClippingRange(0.01, 5.0);
    });
}

TYPED_TEST(CutParity, ParallelAlongAnAxis)
{
  this->expectParityOfCuts(
    Shape::AlongAxes, "along an axis", [](TypeParam& scene) { lookDownZ(scene.camera(), 0.625); });
}

TYPED_TEST(CutParity, StretchedVolumeFarFromTheOrigin)
{
  this->expectParityOfCuts(Shape::FarAway, "stretched and far",
    [](TypeParam& scene)
    {
      const auto [x, y, z] = FarOff;
      scene.Mapper->SetCroppingRegionPlanes(
        x + 0.237, x + 0.711, y + 0.313, y + 0.564, z + 0.159, z + 0.823);
      vtkNew<vtkTransform> transform;
      transform->Translate(0.05, 0.1, 0.0);
      transform->RotateWXYZ(20.0, 1.0, 2.0, 3.0);
      transform->Scale(1.0, 0.7, -0.8);
      transform->Translate(-0.2 - x, 0.1 - y, -0.9 - z);
      scene.Volume->SetUserTransform(transform);
    });
}

// Images are held to their levels everywhere.
TEST(MeshCuts, AtEveryLevel)
{
  for (int level = vtkTetMarchVolumeMapper::FAST; level <= vtkTetMarchVolumeMapper::REFERENCE;
       ++level)
  {
    MeshParity scene;
    Cuts<MeshParity>[2].Change(scene);
    scene.Mapper->SetAccuracyLevel(level);
    scene.expectParity(scene.Mapper->GetAccuracyLevelAsString());
  }
}

// Each of the regions alone, and of some what is left without them. Those of a mesh have closed
// forms.
TEST(StructuredCuts, TwentySevenRegions)
{
  StructuredScene image(imageOf(sineField(), unitCube(6)), 20, 20);
  StructuredScene grid(rectilinearOf(sineField(), unevenCube(6)), 20, 20);
  for (int region = 0; region < 27; ++region)
  {
    SCOPED_TRACE(region);
    crop(image, 1 << region);
    report("region " + std::to_string(region), expectParity(image));
    if (region % 4 == 1)
    {
      crop(grid, 0x7ffffff & ~(1 << region));
      report("without region " + std::to_string(region), expectParity(grid));
    }
  }
}

// The cuts leave a small part of the volume. Rays leap over the empty blocks around it.
TEST(StructuredCuts, EmptySpace)
{
  StructuredScene scene(imageOf(sineField(1.5), unitCube(32)));
  setTwoPeaks(scene.property());
  scene.property()->SetScalarOpacityUnitDistance(0.05);
  crop(scene, VTK_CROP_FENCE);
  clipObliquely(scene);
  report("empty space", expectParity(scene));
}
} // namespace
