// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Dependent components in light, as vtkGPUVolumeRayCastMapper shades those of an image.
//
// Which component's gradient it takes depends on its version and their number: before VTK 9.4 the
// first one's, from then on of four the last one's. So here both rise in the same direction
// everywhere. It takes each component for what it is within its range: they reach from 0 to 1.
#include "ComponentScene.h"
#include "LitRivalScene.h"

#include "vtkAutoInit.h"

#include <gtest/gtest.h>
#include <iostream>

VTK_MODULE_INIT(vtkRenderingVolumeOpenGL2);

namespace
{
using namespace tetmarch::testing;

double rise(double x, double y, double z) { return (x + y * y + z) / 3.0; }
double steeperRise(double x, double y, double z)
{
  const double s = rise(x, y, z);
  return s * (3.0 - s) / 2.0;
}

std::vector<Field> fields(int count)
{
  if (count == 2)
  {
    return { rise, steeperRise };
  }
  return { rise, [](double x, double y, double) { return 0.5 * (x + 1.0 - y); },
    [](double, double y, double z) { return 0.5 * (y + z * z); }, steeperRise };
}

class LitComponentRival : public testing::TestWithParam<Mix>
{
protected:
  LitComponentRival()
    : Shown(withComponents(
              jitteredLattice(LitRivalScene::Cubes, 0.0), fields(GetParam().Components), VTK_FLOAT),
        image())
  {
    vtkVolumeProperty* property = this->Shown.property();
    property->IndependentComponentsOff();
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(0.0, 0.1, 0.3, 1.0);
    color->AddRGBPoint(0.5, 0.9, 0.8, 0.2);
    color->AddRGBPoint(1.0, 1.0, 0.1, 0.6);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, 0.0);
    opacity->AddPoint(0.5, 0.6);
    opacity->AddPoint(1.0, 0.2);
    property->SetColor(color);
    property->SetScalarOpacity(opacity);
    for (int k = 0; k < GetParam().Components; ++k)
    {
      property->SetScalarOpacityUnitDistance(k, 0.25); // ours is the first, the rival's the last
    }
    property->SetDiffuse(0.9); // highlights of VTK before 9.2 are other ones: none here
    this->Shown.Light->SetPosition(3.0, -1.0, 4.0);
  }

  static vtkSmartPointer<vtkImageData> image()
  {
    const std::vector<Field> all = fields(GetParam().Components);
    auto image = makeImage(LitRivalScene::Points, all[0]);
    vtkNew<vtkFloatArray> tuples;
    tuples->SetNumberOfComponents(static_cast<int>(all.size()));
    tuples->SetNumberOfTuples(image->GetNumberOfPoints());
    for (std::size_t k = 0; k < all.size(); ++k)
    {
      auto one = makeImage(LitRivalScene::Points, all[k]);
      tuples->CopyComponent(static_cast<int>(k), one->GetPointData()->GetScalars(), 0);
    }
    image->GetPointData()->SetScalars(tuples);
    return image;
  }

  // They are farther apart if ours is unlit, or has its light elsewhere.
  void expectSameLight()
  {
    const Image rival = this->Shown.pictureBy(this->Shown.Rival);
    const Image ours = this->Shown.pictureBy(this->Shown.Mapper);
    const float black[3] = { 0, 0, 0 };
    const Mask seen = differsFrom(ours, black, 0.05f);
    const auto apart = [&](const char* what, const Image& image)
    {
      const double rms = 255.0 * compare(image, rival, seen, 0.0, Channels::Rgb).Rms;
      std::cout << "[ MEASURED ] " << what << ": RMS " << rms << "/255\n";
      return rms;
    };
    const double same = apart("the same", ours);
    EXPECT_LE(same, LitRivalScene::MostApart);
    EXPECT_GT(apart("nothing", Image(LitRivalScene::Side, LitRivalScene::Side)), 20.0);
    this->Shown.property()->ShadeOff();
    EXPECT_GT(apart("unlit", this->Shown.pictureBy(this->Shown.Mapper)), 3.0 * same);
    this->Shown.property()->ShadeOn();
    this->Shown.Light->SetLightTypeToSceneLight();
    this->Shown.Light->SetPosition(2.0, 0.0, 4.0);
    EXPECT_GT(apart("lit from elsewhere", this->Shown.pictureBy(this->Shown.Mapper)), 1.5 * same);
  }

  LitRivalScene Shown;
};

TEST_P(LitComponentRival, Sun) { this->expectSameLight(); }

TEST_P(LitComponentRival, Headlight)
{
  this->Shown.Light->SetLightTypeToHeadlight();
  this->expectSameLight();
}

INSTANTIATE_TEST_SUITE_P(Of, LitComponentRival, ::testing::Values(Mixes[3], Mixes[4]),
  [](const auto& of) { return of.param.Name; });
} // namespace
