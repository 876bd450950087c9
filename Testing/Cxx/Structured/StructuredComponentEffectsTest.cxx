// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Several components of images: picks, light, and the same picture as that of a mesh.
#include "ComponentTruth.h"
#include "Lights.h"
#include "OwnGradients.h"
#include "StructuredComponents.h"
#include "Unprojection.h"

#include <array>
#include <cmath>

namespace
{
using namespace tetmarch::testing;

class StructuredComponentsOf : public ComponentsTest
{
};

// That a pick is where half of the light is left, by the brute force of all components together.
void expectPicks(StructuredScene& scene, const ComponentTruth& truth)
{
  constexpr double slack = 1.0 / 255.0;
  const int side = scene.Renderer->GetSize()[0];
  const Unprojection unproject(scene.camera());
  int hits = 0;
  for (int y = 2; y < side; y += 5)
  {
    for (int x = 1; x < side; x += 5)
    {
      const double u = 2.0 * (x + 0.5) / side - 1.0;
      const double v = 2.0 * (y + 0.5) / side - 1.0;
      const Vec3 near = unproject(u, v, -1.0);
      const Vec3 far = unproject(u, v, 1.0);
      Vec3 d{ far[0] - near[0], far[1] - near[1], far[2] - near[2] };
      const double length = std::hypot(d[0], d[1], d[2]);
      d = { d[0] / length, d[1] / length, d[2] / length };
      const bool hit = scene.Mapper->Pick(scene.Renderer, scene.Volume, x, y);
      const double opacity = truth.integrate(near, d, 0.0, 10.0)[3];
      EXPECT_EQ(hit, std::abs(opacity - 0.5) < slack ? hit : opacity > 0.5);
      if (hit && opacity > 0.5 + slack)
      {
        ++hits;
        const double* p = scene.Mapper->GetPickedPosition();
        const double found =
          (p[0] - near[0]) * d[0] + (p[1] - near[1]) * d[1] + (p[2] - near[2]) * d[2];
        EXPECT_NEAR(truth.integrate(near, d, 0.0, found)[3], 0.5, slack);
      }
    }
  }
  EXPECT_GT(hits, 8);
}

TEST_P(StructuredComponentsOf, Picks)
{
  const int count = GetParam().Components;
  const auto linear = imageWith(componentFields(count), 6, VTK_DOUBLE);
  const auto scattered = imageWith(scatteredFields(count), 6, VTK_DOUBLE);
  for (const LatticeValues values : AllLatticeValues)
  {
    SCOPED_TRACE(nameOf(values));
    const bool nearest =
      values == LatticeValues::PointsNearest || values == LatticeValues::CellsNearest;
    vtkImageData* image = nearest ? scattered : linear;
    StructuredScene scene(image, 32, 32);
    setFunctions(scene);
    scene.draw(values);
    scene.property()->SetScalarOpacityUnitDistance(0.1);
    scene.Window->Render();
    expectPicks(scene, { image, scene.property(), values, OpacityLaw::Logarithmic });
  }
}

// A mesh of tetrahedra with the same linear fields gives the same picture.
TEST_P(StructuredComponentsOf, ThoseOfAMesh)
{
  constexpr int side = 96;
  const std::vector<Field> fields = componentFields(GetParam().Components);
  Scene mesh(
    withComponents(jitteredLattice(8, 0.15, 1, linearField()), fields, VTK_DOUBLE), side, side);
  drawComponents(mesh, GetParam());
  mesh.Mapper->SetOpacityLawToStructured();
  mesh.Mapper->SetAccuracyLevelToAccurate();
  const auto image = imageWith(fields, 8, VTK_DOUBLE);
  StructuredScene lattice(image, side, side);
  setFunctions(lattice);
  lattice.Mapper->SetAccuracyLevelToAccurate();
  expectPictureOfMesh(lattice.render(), mesh.render(), GetParam().Name);
}

INSTANTIATE_TEST_SUITE_P(Of, StructuredComponentsOf, testing::ValuesIn(Mixes),
  [](const auto& of) { return std::string(of.param.Name); });

class LitStructuredComponents : public ComponentsTest
{
protected:
  LitStructuredComponents()
    : Made(imageWith(wavy(), 8, VTK_DOUBLE))
    , Shown(Made)
  {
    setFunctions(this->Shown);
    setShading(this->Shown.property());
  }
  vtkSmartPointer<vtkImageData> Made;
  StructuredScene Shown;
};

TEST_P(LitStructuredComponents, ShadowsAlongRays)
{
  this->Shown.property()->SetScalarOpacityUnitDistance(0.5);
  this->Shown.addLight(3.0, 4.0, 1.5);
  expectShadowsAlongRays({ LatticeValues::PointsLinear, LatticeValues::CellsLinear }, this->Shown);
}

// The light is that of the component that gives the opacity, which has the same illumination if it
// is alone, as long as both take light at the same points: without splitting, and where no extremes
// of a colour's scalar cut trilinear cells.
TEST_P(LitStructuredComponents, LightIsThatOfTheOpacity)
{
  this->Shown.addLight(3.0, 4.0, 1.5);
  this->Shown.Mapper->SetViewModeToIllumination();
  // At Fast only the mean of one scalar takes the bend of trilinear cells into account. At this
  // level both keep a tolerance of 1/4096, beside which light varies within subsegments, which
  // differ.
  this->Shown.Mapper->SetAccuracyLevelToAccurate();
  for (const LatticeValues values : AllLatticeValues)
  {
    const bool nearest =
      values == LatticeValues::PointsNearest || values == LatticeValues::CellsNearest;
    if (nearest || GetParam().Components == 4)
    {
      this->Shown.draw(values);
      this->Shown.Mapper->SetVectorMode(vtkSmartVolumeMapper::DISABLED);
      const Image together = this->Shown.render();
      this->Shown.Mapper->SetVectorMode(vtkSmartVolumeMapper::COMPONENT);
      this->Shown.Mapper->SetVectorComponent(GetParam().Components - 1);
      const Difference difference = compare(together, this->Shown.render());
      EXPECT_LE(difference.Max, 1.0 / 255.0) << nameOf(values) << ": " << difference.text();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, LitStructuredComponents, testing::Values(Mixes[3], Mixes[4]),
  [](const auto& of) { return std::string(of.param.Name); });

class LitIndependentComponents : public ComponentsTest
{
protected:
  // The reference has finer subsegments, and light in the middle of each.
  static void expectLightOfReference(StructuredScene& scene)
  {
    for (const LatticeValues values : AllLatticeValues)
    {
      scene.draw(values);
      const Image drawn = scene.render();
      const Difference difference = compare(drawn, scene.truth());
      EXPECT_LE(difference.Rms, 0.3 / 255.0) << nameOf(values) << ": " << difference.text();
      expectCounters(scene);
    }
  }
};

TEST_P(LitIndependentComponents, EachIsLitByItsOwnGradient)
{
  const int count = GetParam().Components;
  const auto image = imageWith(linearComponents(count), 8, VTK_DOUBLE);
  for (const LatticeValues values : { LatticeValues::PointsLinear, LatticeValues::CellsLinear })
  {
    SCOPED_TRACE(nameOf(values));
    StructuredScene lit(image), dimmed(image);
    for (StructuredScene* scene : { &lit, &dimmed })
    {
      setFunctions(*scene);
      scene->draw(values);
    }
    expectLightOfOwnGradients(lit, dimmed, count);
  }
}

TEST_P(LitIndependentComponents, ByLightsOfAllKinds)
{
  StructuredScene scene(imageWith(wavy(), 8, VTK_DOUBLE));
  setFunctions(scene);
  for (int k = 0; k < GetParam().Components; ++k)
  {
    scene.property()->ShadeOn(k);
    scene.property()->SetSpecular(k, 0.4);
    scene.property()->SetSpecularPower(k, 10.0);
  }
  expectLightOfReference(scene);
  scene.addLight(3.0, 4.0, 1.5);
  addFadingLight(scene.Renderer);
  addSpotlight(scene.Renderer);
  expectLightOfReference(scene);
}

INSTANTIATE_TEST_SUITE_P(Of, LitIndependentComponents,
  testing::Values(Mixes[0], Mixes[1], Mixes[2]),
  [](const auto& of) { return std::string(of.param.Name); });
} // namespace
