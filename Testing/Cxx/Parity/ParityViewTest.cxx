// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws of a volume of each kind from every kind of camera and by every kind of volume
// matrix, and with opaque geometry in the volume, pixel by pixel against the CPU reference.
#include "ParityScenes.h"

#include "vtkActor.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

template <typename Kind>
const Case<Kind> Cameras[] = {
  { "parallel",
    [](Kind& scene)
    {
      scene.camera()->ParallelProjectionOn();
      scene.camera()->SetParallelScale(0.8);
    } },
  { "inside",
    [](Kind& scene)
    {
      lookFromInside(scene.camera());
      scene.property()->SetScalarOpacityUnitDistance(0.6);
    } },
  { "inside, parallel",
    [](Kind& scene)
    {
      lookFromInside(scene.camera());
      scene.camera()->ParallelProjectionOn();
      scene.camera()->SetParallelScale(0.4);
    } },
  { "cut by the near plane", [](Kind& scene) { scene.camera()->SetClippingRange(2.8, 10.0); } },
  { "cut by the far plane", [](Kind& scene) { scene.camera()->SetClippingRange(1.0, 3.1); } },
  { "cut by both planes", [](Kind& scene) { scene.camera()->SetClippingRange(2.8, 3.2); } },
  { "wide angle",
    [](Kind& scene)
    {
      scene.camera()->SetPosition(0.6, 0.55, 1.3);
      scene.camera()->SetViewAngle(140.0);
      scene.camera()->SetClippingRange(0.05, 10.0);
    } },
  { "narrow angle, from afar",
    [](Kind& scene)
    {
      scene.camera()->SetPosition(700.5, 400.45, 600.5);
      scene.camera()->SetViewAngle(0.09);
      scene.camera()->SetClippingRange(900.0, 1100.0);
    } },
};

template <typename Kind>
void placeBy(Kind& scene, const std::function<void(vtkTransform* transform)>& set)
{
  vtkNew<vtkTransform> transform;
  set(transform);
  scene.Volume->SetUserTransform(transform);
}

template <typename Kind>
const Case<Kind> Matrices[] = {
  { "rotated",
    [](Kind& scene)
    {
      scene.Volume->SetOrigin(0.5, 0.5, 0.5);
      scene.Volume->RotateWXYZ(50.0, 1.0, 2.0, 3.0);
      scene.Volume->SetScale(0.8);
    } },
  { "mirrored",
    [](Kind& scene)
    {
      placeBy(scene,
        [](vtkTransform* mirror)
        {
          mirror->Translate(1.0, 0.0, 0.0);
          mirror->Scale(-1.0, 1.0, 1.0);
        });
    } },
  { "stretched and skewed",
    [](Kind& scene)
    {
      placeBy(scene,
        [](vtkTransform* transform)
        {
          transform->Translate(0.3, 0.4, 0.2);
          transform->RotateWXYZ(35.0, 1.0, 2.0, 3.0);
          transform->Scale(0.5, 1.4, -0.8);
          transform->RotateZ(25.0);
        });
    } },
};

template <typename Kind>
class ParityView : public ::testing::Test
{
protected:
  template <std::size_t Count>
  static void expectParityOfAll(const Case<Kind> (&cases)[Count])
  {
    for (const Shape shape : { Shape::Plain, Shape::Hard })
    {
      for (const Case<Kind>& each : cases)
      {
        Kind scene(shape);
        each.Change(scene);
        scene.expectParity(each.Name + std::string(shape == Shape::Hard ? ", hard" : ", plain"));
      }
    }
  }
};
TYPED_TEST_SUITE(ParityView, ParityKinds, ParityKindNames);

TYPED_TEST(ParityView, EachCamera) { this->expectParityOfAll(Cameras<TypeParam>); }

TYPED_TEST(ParityView, EachMatrix) { this->expectParityOfAll(Matrices<TypeParam>); }

TYPED_TEST(ParityView, OpaqueGeometry)
{
  TypeParam scene;
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 1.0, 1.0 }));
  scene.Renderer->AddActor(makePlane(0.3, 0.4, { 0.0, 0.0, 0.0 }));
  scene.expectParity("inside");
  scene.camera()->ParallelProjectionOn();
  scene.camera()->SetParallelScale(0.8);
  scene.expectParity("inside, parallel");
  scene.camera()->ParallelProjectionOff();
  scene.Renderer->AddActor(makeBall({ 1.4, 0.9, 1.8 }, 0.15, { 1.0, 0.5, 0.2 }));
  scene.expectParity("in front");
  TypeParam inside(Shape::Hard);
  lookFromInside(inside.camera());
  inside.Renderer->AddActor(makeBall({ 0.9, 0.5, 0.4 }, 0.25, { 1.0, 1.0, 1.0 }));
  inside.expectParity("camera inside");
}

TEST(MeshView, ParallelAlongAnAxisOfALattice)
{
  // Rays in the planes of faces, edges and vertices.
  Scene scene(jitteredLattice(8, 0.0, 1, sineField()));
  lookDownZ(scene.camera(), 0.625);
  expectParity(scene);
}

TEST(MeshView, OblongViewport)
{
  Scene scene(jitteredLattice(10, 0.15, 1, sineField()), 200, 90);
  expectParity(scene);
}

TEST(MeshView, NearPlaneVeryNear)
{
  // The depths of the rasteriser can't tell the front faces of the two components apart.
  Scene scene(twoComponents(6, 0.15, 1, sineField()));
  scene.camera()->SetPosition(4.5, 0.9, 1.3);
  for (const bool parallel : { false, true })
  {
    scene.camera()->SetParallelProjection(parallel);
    scene.camera()->SetClippingRange(0.5, 10.0);
    const Image fitting = scene.render();
    expectParity(scene);
    scene.camera()->SetClippingRange(parallel ? -1e8 : 1e-6, parallel ? 1e8 : 1000.0);
    // Without opaque geometry, and with some that hides nothing.
    const auto ball = makeBall({ 0.5, -0.5, 0.5 }, 0.1, { 1.0, 1.0, 1.0 });
    for (int i = 0; i < 2; ++i)
    {
      const Difference difference = compare(scene.render(), fitting);
      EXPECT_LE(difference.Max, 2.0 / 255.0) << difference.text();
      scene.Renderer->AddActor(ball);
    }
    scene.Renderer->RemoveActor(ball);
  }
}

TEST(MeshView, NearPlaneAtAThousandthOfTheFar)
{
  // As near as vtkRenderer::ResetCameraClippingRange() ever sets it.
  Scene scene(twoComponents(6, 0.15, 1, sineField()));
  scene.camera()->SetPosition(4.5, 0.9, 1.3);
  scene.camera()->SetClippingRange(0.02, 20.0);
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 1.0, 1.0 }));
  expectParityWithOpaque(scene);
}
} // namespace
