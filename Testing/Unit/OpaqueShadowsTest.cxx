// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which vertices lie in the shadow of opaque geometry, against closed forms.
#include "Ball.h"
#include "ShadowedEffects.h"

#include "vtkMath.h"
#include "vtkTransform.h"

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

class OpaqueShadowsOf : public ShadowedEffects
{
};

vtkSmartPointer<vtkPolyData> surfaceOf(const Ball& ball)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& point : ball.Points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> polygons;
  for (const auto& [a, b, c] : ball.Triangles)
  {
    polygons->InsertNextCell({ a, b, c });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}

TEST_F(OpaqueShadowsOf, APlateInTheSun)
{
  this->addLight(0.3, 0.2, 1.0); // towards the origin
  this->Renderer->AddActor(plateAt(1.3));
  this->expectShadow(
    0,
    [](const Vector3& p) {
      return depthUnderPlate(p, { { 0.3, 0.2, 1.0 } }, 1.3);
    },
    Rounding);
  EXPECT_EQ(this->Stage.opaqueShadowsRecord().Runs, 1);
  EXPECT_TRUE(this->key().OpaqueShadows);
}

// However far it is: a reach of 1 ends nowhere.
TEST_F(OpaqueShadowsOf, APlateFarOff)
{
  this->addLight(0.0002, 0.0001, 1.0);
  this->Renderer->AddActor(plateAt(500.0));
  this->expectShadow(
    0,
    [](const Vector3& p) {
      return depthUnderPlate(p, { { 0.0002, 0.0001, 1.0 } }, 500.0);
    },
    Rounding);
  this->Options.Reach = 0.999;
  this->expectNoShadow();
}

TEST_F(OpaqueShadowsOf, NoFurtherThanLightIsFollowed)
{
  this->addLight(0.0, 0.0, 1.0);
  this->Renderer->AddActor(plateAt(1.3));
  this->Options.Reach = 0.9;
  this->update();
  const double reach = this->Stage.data().Lights.Reach * this->Mesh.Frame.Radius;
  this->expectShadow(
    0,
    [reach](const Vector3& p) {
      return std::min(depthUnderPlate(p, { { 0.0, 0.0, 1.0 } }, 1.3), reach - (1.3 - p[2]));
    },
    Rounding);
}

TEST_F(OpaqueShadowsOf, APlateBetweenAPointLightAndTheVolume)
{
  const Vector3 source{ { 0.4, 0.7, 2.5 } };
  this->addLightSource(source[0], source[1], source[2]);
  this->Renderer->AddActor(plateAt(1.3));
  this->expectShadow(
    0, [&](const Vector3& p) { return depthUnderPlate(p, source - p, 1.3); }, Rounding);
}

TEST_F(OpaqueShadowsOf, NothingBehindAPointLight)
{
  this->addLightSource(0.4, 0.7, 1.2);
  this->Renderer->AddActor(plateAt(1.3));
  this->expectNoShadow();
}

// The source stands in the volume over it: what is below has no light, what is above has.
TEST_F(OpaqueShadowsOf, APlateInsideOfTheVolume)
{
  const Vector3 source{ { 0.45, 0.6, 0.8 } };
  this->addLightSource(source[0], source[1], source[2]);
  this->Renderer->AddActor(plateAt(0.55));
  this->expectShadow(
    0,
    [&](const Vector3& p) { return std::min(depthUnderPlate(p, source - p, 0.55), 0.55 - p[2]); },
    Rounding);
}

TEST_F(OpaqueShadowsOf, ABallInTheSun)
{
  const Vector3 toSun{ { 0.6, 0.0, 0.8 } };
  const Vector3 centre{ { 0.9, 0.5, 1.1 } };
  constexpr double radius = 0.4;
  this->addLight(toSun[0], toSun[1], toSun[2]);
  const auto actor = actorOf(surfaceOf(Ball(60, 120)));
  actor->SetPosition(centre[0], centre[1], centre[2]);
  actor->SetScale(radius);
  this->Renderer->AddActor(actor);
  this->expectShadow(
    0,
    [&](const Vector3& p)
    {
      const double along = dot(centre - p, toSun);
      Vector3 nearest = p;
      add(along, toSun, nearest);
      const Vector3 off = nearest - centre;
      return radius - std::sqrt(dot(off, off));
    },
    radius * (1.0 - std::pow(std::cos(vtkMath::Pi() / 60.0), 2.0)));
}

TEST_F(OpaqueShadowsOf, EachOfThreeLights)
{
  const Vector3 toSuns[] = { { { 0.3, 0.2, 1.0 } }, { { -0.4, 0.1, 1.0 } } };
  const Vector3 source{ { 0.4, 0.7, 2.5 } };
  this->addHeadlight(); // casts none
  this->addLight(toSuns[0][0], toSuns[0][1], toSuns[0][2]);
  this->addLightSource(source[0], source[1], source[2]);
  this->addLight(toSuns[1][0], toSuns[1][1], toSuns[1][2]);
  this->addLight(0.0, 0.0, 1.0); // the fourth casts none
  this->Renderer->AddActor(plateAt(1.3));
  this->expectShadow(
    0, [&](const Vector3& p) { return depthUnderPlate(p, toSuns[0], 1.3); }, Rounding);
  this->expectShadow(
    1, [&](const Vector3& p) { return depthUnderPlate(p, source - p, 1.3); }, Rounding);
  this->expectShadow(
    2, [&](const Vector3& p) { return depthUnderPlate(p, toSuns[1], 1.3); }, Rounding);
  for (std::uint8_t bits : this->shadows())
  {
    EXPECT_LT(bits, 8);
  }
}

TEST_F(OpaqueShadowsOf, AStretchedAndTurnedVolume)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(0.35, 0.55, 0.5);
  transform->RotateWXYZ(40.0, 1.0, 2.0, 3.0);
  transform->Scale(1.0, 0.4, -0.7);
  transform->Translate(-0.5, -0.5, -0.5);
  this->Volume->SetUserTransform(transform);
  const Vector3 source{ { 0.4, 0.7, 3.5 } };
  this->addLight(0.3, 0.2, 1.0);
  this->addLightSource(source[0], source[1], source[2]);
  this->Renderer->AddActor(plateAt(1.4));
  this->expectShadow(
    0,
    [](const Vector3& p) {
      return depthUnderPlate(p, { { 0.3, 0.2, 1.0 } }, 1.4);
    },
    Rounding);
  this->expectShadow(
    1, [&](const Vector3& p) { return depthUnderPlate(p, source - p, 1.4); }, Rounding);
}

// Vertices of the boundary that lie in the surface of the geometry count as inside of the volume.
TEST_F(OpaqueShadowsOf, AWallOfTheVolume)
{
  this->addLight(1.0, 0.1, 0.2);
  this->Renderer->AddActor(
    actorOf(plate({ { 0.0, -9.0, -9.0 } }, { { 0.0, 9.0, -9.0 } }, { { 0.0, -9.0, 9.0 } })));
  this->expectNoShadow();
  this->Renderer->RemoveAllLights();
  this->addLight(-1.0, 0.1, 0.2);
  for (std::uint8_t bits : this->shadows())
  {
    ASSERT_EQ(bits, 1);
  }
}
} // namespace
