// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// An image and a mesh of tetrahedra of the same linear field, drawn by the same law of opacity,
// give the same picture.
#include "Scene.h"
#include "StructuredScene.h"

#include "vtkActor.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

class OnePath : public testing::Test
{
protected:
  OnePath()
  {
    this->Mesh.Mapper->SetOpacityLawToStructured();
    this->Mesh.Mapper->SetAccuracyLevelToAccurate();
    this->Lattice.Mapper->SetAccuracyLevelToAccurate();
  }

  // For both.
  template <typename Change>
  void change(const Change& apply)
  {
    apply(this->Mesh);
    apply(this->Lattice);
  }

  void expectSame(const std::string& what)
  {
    expectPictureOfMesh(this->Lattice.render(), this->Mesh.render(), what);
  }

  static constexpr int Side = 96;
  Scene Mesh{ jitteredLattice(8, 0.15, 1, linearField()), Side, Side };
  StructuredScene Lattice{ imageOf(linearField(), unitCube(8)), Side, Side };
};

TEST_F(OnePath, SamePictureFromOutsideAndInside)
{
  this->expectSame("outside");
  this->change([](auto& scene) { setSpikyFunctions(scene.property()); });
  this->expectSame("spikes");
  this->change([](auto& scene) { setBumpyFunctions(scene.property()); });
  this->change([](auto& scene) { lookFromInside(scene.camera()); });
  this->expectSame("inside");
}

TEST_F(OnePath, SamePictureByTheOtherLawAndOfARectilinearGrid)
{
  this->change([](auto& scene) { scene.Mapper->SetOpacityLawToUnstructured(); });
  this->expectSame("the other law");
  this->Lattice.Mapper->SetInputData(imageOf(linearField(), unitCube(3)));
  this->expectSame("fewer cells");
  const auto grid = rectilinearOf(linearField(), unevenCube(8));
  this->Lattice.Mapper->SetInputDataObject(grid);
  this->expectSame("rectilinear");
}

// By the structured law lengths are those of the data, by the other those of the world.
TEST_F(OnePath, SamePictureOfAScaledVolume)
{
  this->Mesh.Mapper->SetOpacityLawToStructured();
  for (const double scale : { 1.0, 40.0 })
  {
    this->change(
      [scale](auto& scene)
      {
        scene.Volume->SetScale(1.5 * scale, 0.6 * scale, scale);
        scene.Volume->SetOrientation(10.0, 20.0, 30.0);
        scene.Renderer->ResetCamera();
      });
    this->expectSame("scaled by " + std::to_string(scale));
  }
  const Image large = this->Lattice.render();
  this->change([](auto& scene) { scene.Mapper->SetOpacityLawToUnstructured(); });
  this->expectSame("by the other law");
  this->change(
    [](auto& scene)
    {
      scene.Mapper->SetOpacityLawToStructured();
      scene.Volume->SetScale(1.5, 0.6, 1.0);
      scene.Renderer->ResetCamera();
    });
  const Difference difference = compare(this->Lattice.render(), large);
  std::cout << "[ MEASURED ] small and large: " << difference.text() << '\n';
  EXPECT_LE(difference.Max, 0.5 / 255.0) << "the same but for its size";
}

TEST_F(OnePath, SamePictureInLight)
{
  this->change(
    [](auto& scene)
    {
      setShading(scene.property());
      vtkNew<vtkLight> sun;
      sun->SetLightTypeToSceneLight();
      sun->SetPosition(3.0, 4.0, 1.5);
      sun->SetFocalPoint(0.5, 0.5, 0.5);
      scene.Renderer->AddLight(sun);
    });
  this->expectSame("vertex gradients");
  this->change([](auto& scene) { scene.Mapper->SetGradientTypeToCell(); });
  this->expectSame("cell gradients");
  this->change([](auto& scene) { setGradientOpacity(scene.property()); });
  this->expectSame("gradient opacity");
}

TEST_F(OnePath, SamePictureInEachBlendMode)
{
  for (const int mode :
    { vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, vtkVolumeMapper::MINIMUM_INTENSITY_BLEND,
      vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, vtkVolumeMapper::ADDITIVE_BLEND })
  {
    this->change([&](auto& scene) { scene.Mapper->SetBlendMode(mode); });
    this->expectSame("blend mode " + std::to_string(mode));
  }
}

// In bytes, of which each peel is rounded.
TEST_F(OnePath, SamePictureBetweenTranslucentSurfaces)
{
  this->change(
    [](auto& scene)
    {
      scene.Window->AlphaBitPlanesOn();
      scene.Renderer->SetBackground(0.2, 0.4, 0.6);
      scene.property()->SetScalarOpacityUnitDistance(0.6);
      scene.Renderer->SetUseDepthPeeling(true);
      scene.Renderer->SetUseDepthPeelingForVolumes(true);
      scene.Renderer->SetMaximumNumberOfPeels(20);
      scene.Renderer->SetOcclusionRatio(0.0);
      for (const double height : { 0.8, 0.5, 0.25 })
      {
        const auto plane = makePlane(height, 0.2, { height, 0.3, 1.0 - height });
        plane->GetProperty()->SetOpacity(0.4);
        scene.Renderer->AddActor(plane);
      }
    });
  this->change([](auto& scene) { scene.Window->Render(); });
  const Difference difference =
    compare(this->Mesh.frame(), this->Lattice.frame(), {}, 4.5 / 255.0, Channels::Rgb);
  std::cout << "[ MEASURED ] peeled: " << difference.text() << '\n';
  EXPECT_LE(difference.Percentile999, 4.5 / 255.0) << difference.text();
  EXPECT_EQ(this->Lattice.Mapper->GetNumberOfRays(), 0);
  this->change([](auto& scene) { scene.Volume->VisibilityOff(); });
  const Image lattice = this->Lattice.frame();
  this->change([](auto& scene) { scene.Window->Render(); });
  EXPECT_GT(compare(lattice, this->Lattice.frame()).Max, 0.1);
}
} // namespace
