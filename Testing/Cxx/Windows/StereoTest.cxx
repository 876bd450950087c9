// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Pictures whose rays don't begin in the camera's position: of either eye, or sheared.
#include "CubePicture.h"
#include "Scene.h"

#include "vtkMath.h"
#include "vtkStereoCompositor.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <functional>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 96;
constexpr double EyeAngle = 8.0; // degrees between the eyes, four times VTK's

// A cube of constant extinction: every pixel has a closed form.
class LinesOfSight : public testing::Test
{
protected:
  static constexpr double Extinction = 1.4; // opacity 0.7 by a unit distance of 0.5

  LinesOfSight()
  {
    setPlainFunctions(this->Shown.property(), { 1.0, 1.0, 1.0 }, 0.5 * Extinction);
    this->Shown.property()->SetScalarOpacityUnitDistance(0.5);
    this->camera()->SetEyeAngle(EyeAngle);
  }

  vtkCamera* camera() { return this->Shown.camera(); }

  void expectClosedForm(const char* what)
  {
    const Image drawn = this->Shown.render();
    const double* at = this->Shown.Volume->GetPosition();
    expectCube(drawn, this->camera(), { at[0], at[1], at[2] }, Extinction, Side * Side / 8, what);
    EXPECT_EQ(this->Shown.Mapper->GetNumberOfLostRays(), 0) << what;
  }

  void expectClosedFormOfBothEyes(const char* what)
  {
    this->Shown.Window->StereoRenderOn();
    for (const int eye : { VTK_STEREO_LEFT, VTK_STEREO_RIGHT })
    {
      this->Shown.Window->SetStereoType(eye);
      this->expectClosedForm(what);
    }
  }

  Scene Shown{ jitteredLattice(6, 0.15, 1, constantField(0.5)), Side, Side };
};

TEST_F(LinesOfSight, OfBothEyes) { this->expectClosedFormOfBothEyes("perspective"); }

TEST_F(LinesOfSight, OfBothEyesInParallelProjection)
{
  this->camera()->ParallelProjectionOn();
  this->camera()->SetParallelScale(0.8);
  this->expectClosedFormOfBothEyes("parallel");
}

TEST_F(LinesOfSight, OfBothEyesInsideTheMesh)
{
  this->camera()->SetPosition(0.31, 0.42, 0.57);
  this->camera()->SetFocalPoint(1.0, 0.6, 0.4);
  this->camera()->SetClippingRange(0.01, 5.0);
  this->expectClosedFormOfBothEyes("inside");
}

// VTK has the screen in the coordinates of the camera, from 9.4 on in those of the world and the
// head in their origin: here they are one.
TEST_F(LinesOfSight, OfBothEyesBeforeAScreen)
{
  vtkCamera* camera = this->camera();
  camera->SetPosition(0.0, 0.0, 0.0);
  camera->SetFocalPoint(0.0, 0.0, -2.4);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetClippingRange(0.1, 10.0);
  this->Shown.Volume->SetPosition(-0.4, -0.6, -2.9);
  camera->UseOffAxisProjectionOn();
  camera->SetEyeSeparation(4.0);
  double bottomLeft[] = { -1.0, -1.1, -2.5 }, bottomRight[] = { 1.1, -1.1, -2.3 },
         topRight[] = { 1.1, 1.0, -2.3 };
  camera->SetScreenBottomLeft(bottomLeft);
  camera->SetScreenBottomRight(bottomRight);
  camera->SetScreenTopRight(topRight);
  this->expectClosedFormOfBothEyes("off axis");
}

TEST_F(LinesOfSight, ShearedOrBesideTheMiddle)
{
  vtkCamera* camera = this->camera();
  camera->SetWindowCenter(0.3, -0.2);
  this->expectClosedForm("window centre");
  camera->SetViewShear(0.2, -0.1, 1.0);
  this->expectClosedForm("sheared");
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.8);
  this->expectClosedForm("sheared, parallel");
}

TEST_F(LinesOfSight, ByAMatrixOfTheUsers)
{
  vtkCamera* camera = this->camera();
  camera->SetViewShear(0.2, -0.1, 1.0);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(camera->GetProjectionTransformMatrix(1.0, -1.0, 1.0));
  camera->SetViewShear(0.0, 0.0, 1.0);
  camera->SetExplicitProjectionTransformMatrix(matrix);
  camera->UseExplicitProjectionTransformMatrixOn();
  this->expectClosedForm("explicit");
}

class Stereo : public testing::Test
{
protected:
  Stereo()
  {
    this->Shown.Renderer->SetBackground(0.2, 0.4, 0.6);
    this->Shown.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
    this->Shown.camera()->SetEyeAngle(EyeAngle);
  }

  vtkRenderWindow* window() { return this->Shown.Window; }

  // RGB, as the window's buffer for that eye has it.
  vtkSmartPointer<vtkUnsignedCharArray> pixels(int right = 0)
  {
    auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
    this->window()->GetPixelData(0, 0, Side - 1, Side - 1, 1, bytes, right);
    return bytes;
  }
  vtkSmartPointer<vtkUnsignedCharArray> rendered(int type)
  {
    this->window()->StereoRenderOn();
    this->window()->SetStereoType(type);
    this->window()->Render();
    return this->pixels();
  }

  static int mostApart(vtkUnsignedCharArray* a, vtkUnsignedCharArray* b)
  {
    EXPECT_EQ(a->GetNumberOfValues(), 3 * Side * Side);
    EXPECT_EQ(b->GetNumberOfValues(), 3 * Side * Side);
    int most = 0;
    for (vtkIdType i = 0; i < std::min(a->GetNumberOfValues(), b->GetNumberOfValues()); ++i)
    {
      most = std::max(most, std::abs(int(a->GetValue(i)) - int(b->GetValue(i))));
    }
    return most;
  }

  Scene Shown{ jitteredLattice(6, 0.15, 1, sineField()), Side, Side };
};

// Beside the other by so much that their lines of sight through the focal point make that angle;
// both have the same picture in the plane of the focal point.
TEST_F(Stereo, AnEyeIsACameraOfItsOwn)
{
  const auto left = this->rendered(VTK_STEREO_LEFT);
  const auto right = this->rendered(VTK_STEREO_RIGHT);
  EXPECT_GT(mostApart(left, right), 50);
  this->window()->StereoRenderOff();
  vtkCamera* camera = this->Shown.camera();
  const double slope = std::tan(vtkMath::RadiansFromDegrees(0.5 * EyeAngle));
  const double spread = std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
  Vec3 aside, position, focus;
  vtkMath::Cross(camera->GetDirectionOfProjection(), camera->GetViewUp(), aside.data());
  vtkMath::Normalize(aside.data());
  camera->GetPosition(position.data());
  camera->GetFocalPoint(focus.data());
  const double shift = slope * camera->GetDistance();
  for (const int side : { -1, 1 })
  {
    const auto moved = [&](const Vec3& point)
    {
      return Vec3{ point[0] + side * shift * aside[0], point[1] + side * shift * aside[1],
        point[2] + side * shift * aside[2] };
    };
    camera->SetPosition(moved(position).data());
    camera->SetFocalPoint(moved(focus).data());
    camera->SetWindowCenter(-side * slope / spread, 0.0);
    this->window()->Render();
    // Nothing is rounded otherwise but edges of the ball.
    const auto eye = this->pixels();
    int differ = 0;
    for (vtkIdType i = 0; i < eye->GetNumberOfValues(); ++i)
    {
      const auto* other = side < 0 ? left.Get() : right.Get();
      differ += std::abs(int(eye->GetValue(i)) - int(other->GetValue(i))) > 1 ? 1 : 0;
    }
    EXPECT_LE(differ, 15) << side;
  }
}

// Whatever VTK makes of them.
TEST_F(Stereo, BothEyesMakeOnePicture)
{
  const auto left = this->rendered(VTK_STEREO_LEFT);
  const auto right = this->rendered(VTK_STEREO_RIGHT);
  const int size[] = { Side, Side };
  vtkNew<vtkStereoCompositor> compositor;
  using Bytes = vtkUnsignedCharArray*;
  const std::pair<int, std::function<bool(Bytes, Bytes)>> types[] = {
    { VTK_STEREO_RED_BLUE, [&](Bytes l, Bytes r) { return compositor->RedBlue(l, r); } },
    { VTK_STEREO_ANAGLYPH,
      [&](Bytes l, Bytes r)
      {
        return compositor->Anaglyph(l, r, this->window()->GetAnaglyphColorSaturation(),
          this->window()->GetAnaglyphColorMask());
      } },
    { VTK_STEREO_INTERLACED, [&](Bytes l, Bytes r) { return compositor->Interlaced(l, r, size); } },
    { VTK_STEREO_DRESDEN, [&](Bytes l, Bytes r) { return compositor->Dresden(l, r, size); } },
    { VTK_STEREO_CHECKERBOARD,
      [&](Bytes l, Bytes r) { return compositor->Checkerboard(l, r, size); } },
    { VTK_STEREO_SPLITVIEWPORT_HORIZONTAL,
      [&](Bytes l, Bytes r) { return compositor->SplitViewportHorizontal(l, r, size); } }
  };
  for (const auto& [type, combine] : types)
  {
    const auto drawn = this->rendered(type);
    vtkNew<vtkUnsignedCharArray> expected;
    expected->DeepCopy(left);
    ASSERT_TRUE(combine(expected, right));
    EXPECT_EQ(mostApart(drawn, expected), 0) << this->window()->GetStereoTypeAsString();
  }
}

TEST_F(Stereo, ABufferForEachEye)
{
  const auto left = this->rendered(VTK_STEREO_LEFT);
  const auto right = this->rendered(VTK_STEREO_RIGHT);
  this->window()->StereoRenderOff();
  this->window()->StereoCapableWindowOn();
  EXPECT_EQ(mostApart(this->rendered(VTK_STEREO_CRYSTAL_EYES), left), 0);
  EXPECT_EQ(mostApart(this->pixels(1), right), 0);
  EXPECT_EQ(this->Shown.Mapper->GetMeshBuilds(), 1);
}

TEST_F(Stereo, AtRestNothingIsListedAgain)
{
  const auto buildsOfFrame = [this]
  {
    const auto before = this->Shown.Mapper->GetEntriesBuilds();
    this->rendered(VTK_STEREO_ANAGLYPH);
    return this->Shown.Mapper->GetEntriesBuilds() - before;
  };
  EXPECT_EQ(buildsOfFrame(), 2);
  EXPECT_EQ(buildsOfFrame(), 0);
  this->Shown.camera()->Azimuth(5);
  EXPECT_EQ(buildsOfFrame(), 2);
  EXPECT_EQ(buildsOfFrame(), 0);
}

TEST_F(Stereo, WithSeveralSamplesAPixel)
{
  this->Shown.Renderer->RemoveAllViewProps();
  this->Shown.Renderer->AddVolume(this->Shown.Volume);
  for (const int eye : { VTK_STEREO_LEFT, VTK_STEREO_RIGHT })
  {
    this->window()->SetMultiSamples(0);
    const auto single = this->rendered(eye);
    this->window()->SetMultiSamples(8);
    EXPECT_EQ(mostApart(this->rendered(eye), single), 0);
  }
}
} // namespace
