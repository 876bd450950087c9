// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Shaded as vtkGPUVolumeRayCastMapper shades the same field on an image, with the same lights,
// property and camera, so that whoever changes from images to unstructured grids sees the same.
//
// Where the two can't agree: the rival's normals are central differences over two cells of the
// image, ours are of tetrahedra twice as large; it steps through the volume, we integrate; and both
// round to 8 bits. Its ambient part is of the light's ambient colour unless the only light is a
// headlight, so there is none here otherwise. Before VTK 9.2 its highlights are those of Blinn, and
// for other lights than headlights not even those: its half vector takes the light to come from
// where it goes to.
#include "LitRivalScene.h"

#include "vtkAutoInit.h"
#include "vtkVersionMacros.h"

#include <gtest/gtest.h>
#include <iostream>

VTK_MODULE_INIT(vtkRenderingVolumeOpenGL2);

namespace
{
using namespace tetmarch::testing;

constexpr int Side = LitRivalScene::Side;
constexpr double MostApart = LitRivalScene::MostApart;

Field field() { return sineField(0.5); }

double rms(const Image& a, const Image& b, const Mask& mask)
{
  return 255.0 * compare(a, b, mask, 0.0, Channels::Rgb).Rms;
}

class LightRival : public testing::Test
{
protected:
  LightRival()
  {
    this->property()->SetDiffuse(0.0);
    this->property()->SetSpecularPower(10.0);
    this->Light->SetPosition(3.0, 4.0, 1.5);
  }

  vtkVolumeProperty* property() { return this->Shown.property(); }

  Image ours() { return this->Shown.pictureBy(this->Shown.Mapper); }
  Image rivals()
  {
    const double power = this->property()->GetSpecularPower();
    this->property()->SetSpecularPower(this->RivalPower * power);
    const Image picture = this->Shown.pictureBy(this->Shown.Rival);
    this->property()->SetSpecularPower(power);
    return picture;
  }

  // In 1/255, of the pixels that show the volume.
  double apart()
  {
    this->Picture = this->ours();
    this->RivalPicture = this->rivals();
    this->Seen = silhouette(this->Shown.render(), this->Picture, 0.1f);
    const double apart = rms(this->Picture, this->RivalPicture, this->Seen);
    std::cout << "[ MEASURED ] apart: RMS " << apart << "/255, of a picture of "
              << rms(this->RivalPicture, Image(Side, Side), this->Seen) << "/255\n";
    return apart;
  }

  // They are farther apart if ours has its light 15 degrees beside, or so much brighter; and the
  // picture is no dark one.
  void expectSameLight(double picture = 20.0, double brighter = 1.1)
  {
    const double apart = this->apart();
    EXPECT_LE(apart, MostApart);
    EXPECT_GT(rms(this->RivalPicture, Image(Side, Side), this->Seen), picture);
    const auto expectWorse = [&](const char* what, const Image& other)
    {
      const double worse = rms(other, this->RivalPicture, this->Seen);
      std::cout << "[ MEASURED ] with a light " << what << ": RMS " << worse << "/255\n";
      EXPECT_GT(worse, 1.5 * apart) << what;
    };
    if (this->Light->LightTypeIsSceneLight())
    {
      expectWorse("15 degrees to the left", this->withLightBeside(-15.0));
      expectWorse("15 degrees to the right", this->withLightBeside(15.0));
    }
    this->Light->SetIntensity(brighter);
    expectWorse("that is brighter", this->ours());
  }

  Image withLightBeside(double degrees)
  {
    std::array<double, 3> before{};
    this->Light->GetPosition(before.data());
    vtkNew<vtkCamera> turned;
    turned->SetPosition(before.data());
    turned->SetFocalPoint(this->Light->GetFocalPoint());
    turned->Azimuth(degrees);
    this->Light->SetPosition(turned->GetPosition());
    const Image picture = this->ours();
    this->Light->SetPosition(before.data());
    return picture;
  }

  LitRivalScene Shown{ jitteredLattice(LitRivalScene::Cubes, 0.0, 1, field()),
    makeImage(LitRivalScene::Points, field()) };
  vtkLight* const Light = this->Shown.Light;
  double RivalPower = 1.0; // times ours
  Image Picture;
  Image RivalPicture;
  Mask Seen;
};

TEST_F(LightRival, Unlit)
{
  this->property()->ShadeOff();
  EXPECT_LE(this->apart(), MostApart);
}

TEST_F(LightRival, AmbientOfTheHeadlight)
{
  this->Light->SetLightTypeToHeadlight();
  this->property()->SetAmbient(0.8);
  EXPECT_LE(this->apart(), MostApart);
}

TEST_F(LightRival, DiffuseOfTheHeadlight)
{
  this->Light->SetLightTypeToHeadlight();
  this->property()->SetDiffuse(0.9);
  this->expectSameLight();
}

// The angle to the mirrored light is twice that to the half vector, and cos(2 a)^p is nearly
// cos(a)^(4 p).
TEST_F(LightRival, HighlightsOfTheHeadlight)
{
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
  this->Light->SetLightTypeToHeadlight();
  this->Light->SetSpecularColor(1.0, 0.7, 0.4);
  this->property()->SetSpecular(0.9);
  this->RivalPower = 4.0;
  this->expectSameLight(4.0, 1.3);
#else
  GTEST_SKIP() << "Highlights of Blinn are those of VTK before 9.2";
#endif
}

TEST_F(LightRival, DiffuseOfTheSun)
{
  this->property()->SetDiffuse(0.9);
  this->expectSameLight();
}

TEST_F(LightRival, DiffuseOnOneSide)
{
  this->Shown.Renderer->TwoSidedLightingOff();
  this->property()->SetDiffuse(0.9);
  this->expectSameLight();
}

TEST_F(LightRival, APointLight)
{
  this->Light->PositionalOn();
  this->Light->SetConeAngle(180.0);
  this->Light->SetPosition(1.2, 1.6, 1.0);
  this->Light->SetDiffuseColor(1.0, 0.8, 0.5);
  this->Light->SetAttenuationValues(0.6, 0.2, 0.1);
  this->property()->SetDiffuse(0.9);
  this->expectSameLight();
}

TEST_F(LightRival, ASpotLight)
{
  this->Light->PositionalOn();
  this->Light->SetConeAngle(40.0);
  this->Light->SetExponent(20.0); // no sharp edge, which each would have elsewhere by a step
  this->Light->SetPosition(1.7, 1.6, 1.6);
  this->property()->SetDiffuse(0.9);
  this->expectSameLight();
}
} // namespace
