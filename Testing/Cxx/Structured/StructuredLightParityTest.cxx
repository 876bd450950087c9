// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Light in data that only images and rectilinear grids have, and light that is sampled along rays,
// pixel by pixel against the CPU reference.
#include "Lights.h"
#include "StructuredScene.h"

#include "vtkDataSetAttributes.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

constexpr Promises Lit{ true, false };

class StructuredLight : public testing::Test
{
protected:
  StructuredLight() { setShading(this->Shown.property()); }
  void addSun() { this->Shown.addLight(3.0, 4.0, 1.5); }

  StructuredScene Shown{ imageOf(sineField(), unitCube(8)) };
};

// Gradients of an image that its own directions turn.
TEST_F(StructuredLight, ImagesInAllPlaces)
{
  for (const ImagePlace& place : imagePlaces())
  {
    SCOPED_TRACE(place.Name);
    StructuredScene scene(imageOf(sineField(), place), 20, 20);
    setShading(scene.property());
    scene.lookAtAll();
    report(place.Name + ", lit", expectParity(scene, Lit));
  }
}

TEST_F(StructuredLight, RectilinearWithHiddenCells)
{
  const auto grid = rectilinearOf(sineField(), unevenCube(7));
  markCells(grid, vtkDataSetAttributes::HIDDENCELL, [](vtkIdType id) { return id % 13 == 3; });
  StructuredScene scene(grid);
  setShading(scene.property());
  scene.addLight(3.0, 4.0, 1.5);
  expectParityOf(AllLatticeValues, scene, "rectilinear, lit", Lit);
}

TEST_F(StructuredLight, ShadowsAlongRays)
{
  this->addSun();
  this->Shown.property()->SetScalarOpacityUnitDistance(0.5);
  expectShadowsAlongRays(
    { LatticeValues::PointsLinear, LatticeValues::PointsNearest, LatticeValues::CellsLinear },
    this->Shown);
}

TEST_F(StructuredLight, ShadowsOfThreeLightsThroughGradientOpacity)
{
  setGradientOpacity(this->Shown.property());
  this->addSun();
  addLightsThatCastShadows(this->Shown.Renderer);
  this->Shown.Mapper->SetShadowMethodToAlongRays();
  expectLightAlongRays(this->Shown, "three lights");
  this->Shown.Mapper->SetGlobalIlluminationReach(0.3f);
  expectLightAlongRays(this->Shown, "three lights, short reach");
}

TEST_F(StructuredLight, Scattering)
{
  this->addSun();
  this->Shown.property()->SetScalarOpacityUnitDistance(0.5);
  this->Shown.Mapper->SetShadowMethodToAlongRays();
  for (const float blending : { 0.5f, 1.0f, 1.5f, 2.0f })
  {
    this->Shown.Mapper->SetVolumetricScatteringBlending(blending);
    expectLightAlongRays(this->Shown, "scattering " + std::to_string(blending));
  }
}
} // namespace
