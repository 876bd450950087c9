// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// After VTK's TestGPURayCastCameraInside, its variants Clipping, NonUniformScaleTransform,
// SmallSpacing and Transformation, TestGPURayCastPerspectiveParallel, and
// TestGPURayCastModelTransformMatrix.
#include "VtkScene.h"

#include "CpuReference.h"

#include "vtkActor.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkMatrix4x4.h"
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

// A camera that goes into a volume, through it and out again.
TEST_F(CameraScene, GoesThroughTheVolume)
{
  this->show(makeWavelet(), 0.04);
  setFunctions(this->Shown->property(), 40.0, 280.0, 0.3);
  for (const double place : { 30.0, 9.7, 3.0, -4.0 })
  {
    this->look({ 0.3 * place, 0.2 * place, place }, { 1.0, 2.0, place - 12.0 });
    this->expectBoth(2.0, "at " + std::to_string(place));
  }
}

// Corners before the near plane, with a wide angle, about a ball.
TEST_F(CameraScene, NearPlaneThroughCorners)
{
  this->show(makeWavelet(), 0.04);
  setFunctions(this->Shown->property(), 40.0, 280.0, 0.3);
  this->Shown->Renderer->AddActor(makeBall({ 3.0, -4.0, -2.0 }, 4.0, { 1.0, 1.0, 1.0 }));
  this->look({ 0.0, 2.0, 13.0 }, { 0.0, 2.0, -3.0 });
  this->camera()->SetViewAngle(110.0);
  this->camera()->Elevation(-45.0);
  this->camera()->OrthogonalizeViewUp();
  this->camera()->Azimuth(34.9);
  this->camera()->OrthogonalizeViewUp();
  for (const double near : { 0.1, 2.0, 6.0 })
  {
    this->camera()->SetClippingRange(near, 60.0);
    expectParityWithOpaque(*this->Shown);
    expectLike(*this->Shown, this->Rival, 3.0, "near plane at " + std::to_string(near));
  }
}

// An angle of 170 degrees in a volume that a matrix stretches.
TEST_F(CameraScene, InsideAStretchedVolume)
{
  this->show(makeWavelet(), 0.04);
  setFunctions(this->Shown->property(), 40.0, 280.0, 0.1);
  vtkNew<vtkMatrix4x4> matrix;
  const double rows[16] = { 3.2, 0, 0, 20, 0, 3.2, 0, 10, 0, 0, 1.5, 4, 0, 0, 0, 1 };
  matrix->DeepCopy(rows);
  this->Shown->Volume->PokeMatrix(matrix);
  this->look({ 25.7, 16.9, 3.9 }, { 17.8, 11.1, 14.2 }, { -0.105, 0.899, 0.424 });
  this->camera()->SetViewAngle(170.0);
  this->camera()->SetClippingRange(0.01, 200.0);
  expectParity(*this->Shown);
}

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

TEST_F(CameraScene, BeforeATurnedVolume)
{
  this->show(makeWavelet(), 0.04);
  setFunctions(this->Shown->property(), 40.0, 280.0, 0.3);
  vtkVolume* volume = this->Shown->Volume;
  volume->RotateX(180.0);
  volume->RotateY(85.0);
  volume->RotateZ(55.0);
  volume->SetOrigin(30.0, 2.0, 3.0);
  const double* centre = volume->GetCenter();
  const Vec3 middle{ centre[0], centre[1], centre[2] };
  this->look({ middle[0] + 20.0, middle[1] + 9.0, middle[2] - 31.0 }, middle);
  this->expectBoth(2.5, "before it");
  this->look({ middle[0] + 3.0, middle[1] + 2.0, middle[2] - 4.0 }, middle);
  this->camera()->SetClippingRange(0.01, 60.0);
  this->expectBoth(2.5, "inside");
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

// Colours on a sphere that ends within a hundredth of its value.
TEST_F(CameraScene, PerspectiveAndParallel)
{
  const auto image = makeShell(27);
  this->show(image, 0.02);
  vtkVolumeProperty* property = this->Shown->property();
  setFunctions(property, 0.0, 160.0, 0.5);
  property->GetScalarOpacity()->AddPoint(160.1, 0.0);
  property->GetScalarOpacity()->AddPoint(255.0, 0.0);
  this->look({ 17.0, 23.0, 97.0 }, { 13.0, 13.0, 13.0 });
  this->Shown->Renderer->ResetCamera();
  this->expectBoth(5.0, "perspective");
  this->camera()->ParallelProjectionOn();
  this->expectBoth(5.0, "parallel");
}
} // namespace
