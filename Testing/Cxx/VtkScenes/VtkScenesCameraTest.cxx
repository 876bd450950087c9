// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// After VTK's TestGPURayCastCameraInsideSmallSpacing and TestGPURayCastModelTransformMatrix: a
// scene that must look like another one.
#include "VtkScene.h"

#include "CpuReference.h"

#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkTransform.h"

#include <memory>

namespace
{
using namespace tetmarch::testing;

constexpr int Width = 91; // odd, and not as high
constexpr int Height = 90;

class CameraScene : public testing::Test
{
protected:
  void show(vtkImageData* image, double step)
  {
    this->Shown = std::make_unique<Scene>(tetrahedraOf(image), Width, Height);
    this->Shown->Mapper->SetOpacityLawToStructured();
    this->Shown->property()->SetScalarOpacityUnitDistance(1.0);
    this->Shown->Renderer->SetBackground(0.1, 0.4, 0.2);
    this->Rival = makeImageMapper(image, step);
  }
  vtkCamera* camera() { return this->Shown->camera(); }
  void look(const Vec3& from, const Vec3& at, const Vec3& up = { 0.0, 1.0, 0.0 })
  {
    this->camera()->SetPosition(from.data());
    this->camera()->SetFocalPoint(at.data());
    this->camera()->SetViewUp(up.data());
    this->Shown->Renderer->ResetCameraClippingRange();
  }
  void expectBoth(double mostRms, const std::string& what = {})
  {
    expectParity(*this->Shown);
    expectLike(*this->Shown, this->Rival, mostRms, what);
  }

  std::unique_ptr<Scene> Shown;
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> Rival;
};

// A volume of half a thousandth is seen as one of twenty.
TEST_F(CameraScene, InsideATinyVolume)
{
  constexpr double Spacing = 0.0005 / 21.0;
  std::vector<Image> pictures;
  for (const double unit : { 1.0, Spacing })
  {
    const auto image = makeWavelet();
    image->SetSpacing(unit, unit, unit);
    this->show(image, 0.04 * unit);
    setFunctions(this->Shown->property(), 40.0, 280.0, 0.3);
    this->Shown->property()->SetScalarOpacityUnitDistance(unit);
    this->look({ 4.4 * unit, 2.2 * unit, 5.8 * unit }, { 0.5 * unit, -2.5 * unit, 0.0 },
      { -0.217, 0.824, -0.524 });
    this->camera()->SetClippingRange(0.04 * unit, 40.0 * unit);
    expectParity(*this->Shown);
    pictures.push_back(this->Shown->render());
  }
  const Difference difference = compare(pictures[0], pictures[1]);
  std::cout << "[ MEASURED ] tiny and not: " << difference.text() << '\n';
  EXPECT_LE(difference.Max, 0.1 / 255.0) << difference.text();
}

// Of the camera, by which VTK moves all that is shown: as if the volume had it. (VTK 9.1's own
// mapper knows nothing of it.)
TEST_F(CameraScene, WithAMatrixOfTheModel)
{
  this->show(makeWavelet(), 0.04);
  setFunctions(this->Shown->property(), 40.0, 280.0, 0.3);
  this->look({ 12.0, 20.0, 34.0 }, { 0.0, 0.0, 0.0 });
  vtkNew<vtkTransform> turn;
  turn->RotateY(60.0);
  this->Shown->Volume->SetUserTransform(turn);
  this->expectBoth(2.0);
  const Image turned = this->Shown->render();
  this->Shown->Volume->SetUserTransform(nullptr);
  EXPECT_GT(compare(this->Shown->render(), turned).Max, 0.2);
  this->camera()->SetModelTransformMatrix(turn->GetMatrix());
  EXPECT_LE(compare(this->Shown->render(), turned).Max, 1e-5);
}
} // namespace
