// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws of a cube of constant extinction that is clipped or cropped, pixel by pixel
// against the closed form.
#include "CutScene.h"
#include "Unprojection.h"

#include "ClosedForms.h"
#include "CutLine.h"

#include "vtkTransform.h"

#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

constexpr double Extinction = 0.7; // by a unit distance of 0.5

class CutCubePicture : public ::testing::Test
{
protected:
  CutCubePicture()
  {
    setPlainFunctions(this->Shown.property(), { 1.0, 1.0, 1.0 }, 0.5 * Extinction);
    this->Shown.property()->SetScalarOpacityUnitDistance(0.5);
    this->Shown.Volume->SetUserTransform(this->Transform);
  }

  // In the world and in the data, of clip coordinates.
  tetmarch::testing::CutPoint pointOf(double x, double y, double z)
  {
    CutPoint point{ Unprojection(this->Shown.camera())(x, y, z), {} };
    this->Transform->GetInverse()->TransformPoint(point.World.data(), point.Data.data());
    return point;
  }

  double opacityAt(int column, int row)
  {
    const double x = (column + 0.5) / Side * 2.0 - 1.0, y = (row + 0.5) / Side * 2.0 - 1.0;
    const CutPoint near = this->pointOf(x, y, -1.0), far = this->pointOf(x, y, 1.0);
    // The fractions of the line at which it enters and leaves the cube.
    double begin = 0.0, end = 1.0;
    for (int k = 0; k < 3; ++k)
    {
      const double a = -near.Data[k] / (far.Data[k] - near.Data[k]);
      const double b = (1.0 - near.Data[k]) / (far.Data[k] - near.Data[k]);
      begin = std::max(begin, std::min(a, b));
      end = std::min(end, std::max(a, b));
    }
    if (!(begin < end))
    {
      return 0.0;
    }
    const auto at = [&](double fraction)
    {
      return CutPoint{ mixed(near.World, far.World, fraction),
        mixed(near.Data, far.Data, fraction) };
    };
    const CutPoint enter = at(begin), leave = at(end);
    const double length = std::hypot(leave.World[0] - enter.World[0],
      leave.World[1] - enter.World[1], leave.World[2] - enter.World[2]);
    return slabOpacity(Extinction, length * fractionLeft(this->optionsOfMapper(), enter, leave));
  }

  tetmarch::ClippingOptions optionsOfMapper()
  {
    tetmarch::ClippingOptions options;
    options.Planes = this->Shown.Mapper->GetClippingPlanes();
    options.Cropping = this->Shown.Mapper->GetCropping();
    this->Shown.Mapper->GetCroppingRegionPlanes(options.CroppingPlanes.data());
    options.CroppingFlags = this->Shown.Mapper->GetCroppingRegionFlags();
    return options;
  }

  // At least so many pixels show something; returns the greatest error.
  double expectClosedForm(int leastPixels)
  {
    const Image drawn = this->Shown.render();
    double most = 0.0;
    int seen = 0;
    for (int row = 0; row < Side; ++row)
    {
      for (int column = 0; column < Side; ++column)
      {
        const double opacity = this->opacityAt(column, row);
        const double error = std::abs(double(drawn.pixel(column, row)[3]) - opacity);
        most = std::max(most, error);
        seen += opacity > 0.0 ? 1 : 0;
        EXPECT_LE(error, 1e-4) << column << ", " << row;
      }
    }
    EXPECT_GE(seen, leastPixels);
    EXPECT_EQ(this->Shown.Mapper->GetNumberOfLostRays(), 0);
    EXPECT_EQ(this->Shown.Mapper->GetNumberOfGuardHits(), 0);
    return most;
  }

  void expectClosedFormOf(const char* what, int leastPixels = 500)
  {
    SCOPED_TRACE(what);
    std::cout << "[ MEASURED ] " << what << ": greatest error of opacity "
              << this->expectClosedForm(leastPixels) << '\n';
  }

  static constexpr int Side = 96;
  Scene Shown{ jitteredLattice(6, 0.15, 1, constantField(0.5)), Side, Side };
  vtkNew<vtkTransform> Transform;
};

TEST_F(CutCubePicture, ByPlanes)
{
  this->expectClosedFormOf("whole");
  clipObliquely(this->Shown);
  this->expectClosedFormOf("one plane");
  addClippingPlane(this->Shown, { 0.5, 0.7, 0.5 }, { 0.1, -2.0, 0.3 });
  this->expectClosedFormOf("two planes");
  addClippingPlane(this->Shown, { 0.31, 0.0, 0.0 }, { 5.0, 0.0, 0.0 });
  this->expectClosedFormOf("three planes");
}

TEST_F(CutCubePicture, ByPlanesThatFaceTheOtherWay)
{
  vtkPlane* plane = clipObliquely(this->Shown);
  const double* n = plane->GetNormal();
  plane->SetNormal(-n[0], -n[1], -n[2]);
  this->expectClosedFormOf("the other side");
}

TEST_F(CutCubePicture, InParallelProjection)
{
  this->Shown.camera()->ParallelProjectionOn();
  this->Shown.camera()->SetParallelScale(0.8);
  clipObliquely(this->Shown);
  this->expectClosedFormOf("parallel");
  // Along the plane: of neighbouring pixels one sees all and one nothing.
  this->Shown.camera()->SetPosition(0.5, 0.5, 3.0);
  this->Shown.camera()->SetFocalPoint(0.5, 0.5, 0.5);
  this->Shown.camera()->SetParallelScale(0.4);
  this->Shown.Mapper->RemoveAllClippingPlanes();
  addClippingPlane(this->Shown, { 0.3, 0.0, 0.0 }, { 1.0, 0.0, 0.0 });
  this->expectClosedFormOf("along the plane");
  crop(this->Shown, VTK_CROP_CROSS);
  this->expectClosedFormOf("along planes of cropping");
}

TEST_F(CutCubePicture, FromInside)
{
  this->Shown.camera()->SetPosition(0.31, 0.42, 0.57);
  this->Shown.camera()->SetFocalPoint(1.0, 0.6, 0.4);
  this->Shown.camera()->SetClippingRange(0.01, 5.0);
  addClippingPlane(this->Shown, { 0.6, 0.5, 0.5 }, { 1.0, 0.3, 0.2 });
  this->expectClosedFormOf("clipped before the eye", Side * Side);
  crop(this->Shown, VTK_CROP_INVERTED_CROSS);
  this->expectClosedFormOf("and cropped", Side * Side / 2);
}

TEST_F(CutCubePicture, BetweenNearAndFarPlane)
{
  this->Shown.camera()->SetClippingRange(2.8, 3.2);
  clipObliquely(this->Shown);
  this->expectClosedFormOf("clipped", 100);
  crop(this->Shown, VTK_CROP_FENCE);
  this->expectClosedFormOf("and cropped", 100);
}

TEST_F(CutCubePicture, OfAStretchedAndTurnedVolume)
{
  this->Transform->Translate(0.3, 0.4, 0.2);
  this->Transform->RotateWXYZ(35.0, 1.0, 2.0, 3.0);
  this->Transform->Scale(0.5, 1.4, -0.8);
  this->Transform->RotateZ(25.0);
  clipObliquely(this->Shown);
  this->expectClosedFormOf("clipped");
  crop(this->Shown, VTK_CROP_FENCE);
  this->expectClosedFormOf("and cropped");
}

TEST_F(CutCubePicture, ByCroppingOfEveryKind)
{
  double most = 0.0;
  for (const int flags : croppingFlagsToTest())
  {
    SCOPED_TRACE(flags);
    crop(this->Shown, flags);
    most = std::max(most, this->expectClosedForm(30));
  }
  std::cout << "[ MEASURED ] greatest error of opacity " << most << '\n';
}

TEST_F(CutCubePicture, ByTheNamedCroppings)
{
  vtkTetMarchVolumeMapper* mapper = this->Shown.Mapper;
  crop(this->Shown, 0);
  mapper->SetCroppingRegionFlagsToSubVolume();
  EXPECT_EQ(mapper->GetCroppingRegionFlags(), 0x0002000);
  this->expectClosedFormOf("sub-volume");
  mapper->SetCroppingRegionFlagsToFence();
  EXPECT_EQ(mapper->GetCroppingRegionFlags(), 0x2ebfeba);
  this->expectClosedFormOf("fence");
  mapper->SetCroppingRegionFlagsToInvertedFence();
  EXPECT_EQ(mapper->GetCroppingRegionFlags(), 0x5140145);
  this->expectClosedFormOf("inverted fence");
  mapper->SetCroppingRegionFlagsToCross();
  EXPECT_EQ(mapper->GetCroppingRegionFlags(), 0x0417410);
  this->expectClosedFormOf("cross");
  mapper->SetCroppingRegionFlagsToInvertedCross();
  EXPECT_EQ(mapper->GetCroppingRegionFlags(), 0x7be8bef);
  this->expectClosedFormOf("inverted cross");
}

// Two layers, seen one before the other: each alone is a box, which planes cut out, and both
// together are cropped segment by segment. Most cells between have a segment in either.
class Layers : public ::testing::Test
{
protected:
  Layers()
  {
    // A segment is one lookup, whatever is before it; and nothing is opaque.
    this->Shown.Mapper->SetAccuracyLevelToFast();
    this->Shown.property()->SetScalarOpacityUnitDistance(0.6);
    this->Shown.Mapper->CroppingOn();
    this->Shown.Mapper->SetCroppingRegionPlanes(-1.0, 2.0, -1.0, 2.0, 0.48, 0.53);
    this->Shown.addGradientOpacity();
  }

  Image pictureOf(int flags)
  {
    this->Shown.Mapper->SetCroppingRegionFlags(flags);
    return this->Shown.render();
  }

  void expectOneBeforeTheOther(const char* what)
  {
    constexpr int behind = 1 << 4, before = 1 << 22;
    const Image front = this->pictureOf(before), back = this->pictureOf(behind);
    const Image both = this->pictureOf(before | behind);
    Image composed = front;
    for (std::size_t i = 0; i < composed.Rgba.size(); ++i)
    {
      composed.Rgba[i] += (1.0f - front.Rgba[i | 3]) * back.Rgba[i];
    }
    const Difference difference = compare(both, composed);
    EXPECT_LE(difference.Max, 1e-5) << what;
    EXPECT_GT(compare(both, front).Max, 0.05) << what;
    std::cout << "[ MEASURED ] " << what << ": " << difference.text() << '\n';
  }

  LitScene Shown{ jitteredLattice(4, 0.15, 1, sineField()), 96, 96 };
};

TEST_F(Layers, OfPointScalars)
{
  this->expectOneBeforeTheOther("gradients of vertices");
  this->Shown.Mapper->SetShadowMethodToAtVertices();
  this->expectOneBeforeTheOther("shadows");
  this->Shown.Mapper->SetGradientTypeToCell();
  this->expectOneBeforeTheOther("gradients of cells");
  this->Shown.property()->ShadeOff();
  this->expectOneBeforeTheOther("no light");
}

TEST_F(Layers, OfCellScalars)
{
  this->Shown.drawCellScalars();
  this->expectOneBeforeTheOther("lit");
  this->Shown.property()->ShadeOff();
  this->expectOneBeforeTheOther("no light");
}
} // namespace
