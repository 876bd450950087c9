// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Scalars that are not finite, drawn in a colour of their own.
#include "CpuReference.h"
#include "GapScene.h"
#include "LitScene.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch::testing;
using Limits = std::numeric_limits<double>;

constexpr int Side = 96;

TEST(NanCells, OpacityIsAsTheLawSays)
{
  // Down z through a cube of which the middle half isn't finite.
  const Grid grid = jitteredLattice(4, 0.0, 1, constantField(0.5));
  vtkDataArray* scalars = grid->GetCellData()->GetScalars();
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    double b[6];
    grid->GetCellBounds(cell, b);
    if (b[4] + b[5] > 0.5 && b[4] + b[5] < 1.5)
    {
      scalars->SetTuple1(cell, NotFinite[cell % 3]);
    }
  }
  Scene scene(grid, Side, Side);
  scene.drawCellScalars();
  setPlainFunctions(scene.property(), { 1.0, 0.0, 0.0 }, 0.5);
  scene.property()->GetRGBTransferFunction()->SetNanColorRGBA(0.0, 0.8, 0.4, 0.6);
  scene.property()->SetScalarOpacityUnitDistance(0.5);
  lookDownZ(scene.camera(), 0.4);
  for (const bool structured : { false, true })
  {
    scene.Mapper->SetOpacityLaw(
      structured ? vtkTetMarchVolumeMapper::STRUCTURED : vtkTetMarchVolumeMapper::UNSTRUCTURED);
    // Depths over half a unit cube, which is a unit distance, and over a quarter.
    const double nan = structured ? -std::log(0.4) : 0.6;
    const double quarter = 0.5 * (structured ? -std::log(0.5) : 0.5);
    for (const bool shown : { false, true })
    {
      scene.Mapper->SetDrawNanCells(shown);
      const double middle = shown ? -std::expm1(-nan) : 0.0;
      const double side = -std::expm1(-quarter);
      const Image picture = scene.render();
      for (std::size_t i = 0; i < picture.Rgba.size(); i += 4)
      {
        ASSERT_NEAR(picture.Rgba[i], side + (1.0 - side) * (1.0 - middle) * side, 2e-5);
        ASSERT_NEAR(picture.Rgba[i + 1], (1.0 - side) * middle * 0.8, 2e-5);
        ASSERT_NEAR(picture.Rgba[i + 2], (1.0 - side) * middle * 0.4, 2e-5);
        ASSERT_NEAR(picture.Rgba[i + 3], 1.0 - (1.0 - side) * (1.0 - side) * (1.0 - middle), 2e-5);
      }
    }
  }
}

TEST(NanCells, AreAllThatIsDrawnWhereNothingIsFinite)
{
  const Grid grid = jitteredLattice(4, 0.1, 1, constantField(Limits::quiet_NaN()));
  Scene scene(grid, Side, Side);
  scene.Window->Render();
  EXPECT_EQ(scene.render().pixel(Side / 2, Side / 2)[3], 0.0f);
  scene.Mapper->DrawNanCellsOn();
  const Image picture = scene.render();
  EXPECT_GT(picture.pixel(Side / 2, Side / 2)[3], 0.9f);
  EXPECT_EQ(picture.pixel(Side / 2, Side / 2)[1], 0.0f); // VTK's dark red
  // Where no scalar has an opacity either.
  scene.property()->GetScalarOpacity()->RemoveAllPoints();
  scene.property()->GetScalarOpacity()->AddPoint(0.0, 0.0);
  EXPECT_EQ(compare(scene.render(), picture).Max, 0.0);
  scene.property()->GetRGBTransferFunction()->SetNanOpacity(0.0);
  scene.Window->Render();
  const Image nothing = scene.frame();
  scene.Mapper->DrawNanCellsOff();
  scene.Window->Render();
  EXPECT_EQ(compare(scene.frame(), nothing).Max, 0.0);
}

TEST(NanCells, ChangeNothingWhereAllIsFinite)
{
  Scene scene(jitteredLattice(6, 0.15, 1, sineField()), Side, Side);
  const Image picture = scene.render();
  scene.Mapper->DrawNanCellsOn();
  EXPECT_EQ(compare(scene.render(), picture).Max, 0.0);
}

TEST(NanCells, AreSwitchedWithoutAnyStage)
{
  const Grid grid = jitteredLattice(6, 0.15, 1, sineField());
  breakSome(grid->GetPointData()->GetScalars());
  Scene scene(grid, Side, Side);
  const Image without = scene.render();
  const vtkTypeInt64 bytes = scene.Mapper->GetUploadedBytes();
  scene.Mapper->DrawNanCellsOn();
  const Image shown = scene.render();
  EXPECT_GT(compare(shown, without).Max, 0.1);
  EXPECT_EQ(scene.Mapper->GetUploadedBytes(), bytes);
  EXPECT_EQ(scene.Mapper->GetMeshBuilds(), 1);
  EXPECT_EQ(scene.Mapper->GetScalarsBuilds(), 1);
  EXPECT_EQ(scene.Mapper->GetTablesBuilds(), 1);
  scene.property()->GetRGBTransferFunction()->SetNanColor(0.0, 0.0, 1.0);
  EXPECT_GT(compare(scene.render(), shown).Max, 0.1);
  EXPECT_EQ(scene.Mapper->GetScalarsBuilds(), 1);
  scene.Mapper->DrawNanCellsOff();
  EXPECT_EQ(compare(scene.render(), without).Max, 0.0);
  // A gray function has no such colour.
  scene.Mapper->DrawNanCellsOn();
  vtkNew<vtkPiecewiseFunction> gray;
  gray->AddPoint(0.0, 0.5);
  scene.property()->SetColor(gray);
  const Image grayOn = scene.render();
  scene.Mapper->DrawNanCellsOff();
  EXPECT_EQ(compare(scene.render(), grayOn).Max, 0.0);
}

// Cells of the NaN colour are shown fully lit, and without a gradient.
TEST(NanCells, InViewsOfLightAndGradients)
{
  LitScene scene(jitteredLattice(4, 0.1, 1, constantField(Limits::infinity())), Side, Side);
  scene.Mapper->DrawNanCellsOn();
  const auto expectGray = [&](float share)
  {
    const Image picture = scene.render();
    const float* pixel = picture.pixel(Side / 2, Side / 2);
    EXPECT_GT(pixel[3], 0.9f);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(pixel[k], share * pixel[3], 1e-5f);
    }
  };
  scene.Mapper->SetViewModeToIllumination();
  expectGray(1.0f);
  scene.Mapper->SetViewModeToGradients();
  expectGray(0.5f);
}

class NanParity : public testing::TestWithParam<bool>
{
protected:
  NanParity()
  {
    vtkUnstructuredGrid* grid = this->Shown.Data;
    breakSome(grid->GetPointData()->GetScalars());
    breakSome(grid->GetCellData()->GetScalars());
    if (GetParam())
    {
      this->Shown.drawCellScalars();
    }
    this->Shown.Mapper->DrawNanCellsOn();
    this->Shown.property()->GetRGBTransferFunction()->SetNanColorRGBA(0.9, 0.2, 0.7, 0.4);
  }

  LitScene Shown{ jitteredLattice(9, 0.15, 1, sineField()) };
};

TEST_P(NanParity, Unlit)
{
  this->Shown.property()->ShadeOff();
  expectParity(this->Shown);
  this->Shown.Mapper->SetAccuracyLevelToFast();
  expectParity(this->Shown);
}

TEST_P(NanParity, OneColour)
{
  this->Shown.property()->ShadeOff();
  vtkColorTransferFunction* colors = this->Shown.property()->GetRGBTransferFunction();
  colors->RemoveAllPoints();
  colors->AddRGBPoint(0.0, 0.1, 0.9, 0.5);
  expectParity(this->Shown);
}

TEST_P(NanParity, TransparentRanges)
{
  setSpikyFunctions(this->Shown.property());
  this->Shown.property()->GetRGBTransferFunction()->SetNanColorRGBA(0.9, 0.2, 0.7, 0.4);
  expectParity(this->Shown);
  this->Shown.property()->ShadeOff();
  expectParity(this->Shown);
}

TEST_P(NanParity, InLightAndShadow)
{
  expectParity(this->Shown);
  this->Shown.Mapper->SetShadowMethodToAtVertices();
  this->Shown.Mapper->AmbientOcclusionOn();
  this->Shown.addGradientOpacity();
  expectParity(this->Shown);
}

// Shadows along rays are sampled at random: the picture is as bright in the mean.
TEST_P(NanParity, ShadowsAlongRaysAreThoseAtVertices)
{
  this->Shown.Mapper->SetShadowMethodToAtVertices();
  const double atVertices = this->Shown.brightness();
  this->Shown.Mapper->SetShadowMethodToAlongRays();
  EXPECT_NEAR(this->Shown.brightness() / atVertices, 1.0, 0.03);
}

INSTANTIATE_TEST_SUITE_P(
  OfAll, NanParity, testing::Bool(), [](const auto& of) { return of.param ? "Cells" : "Points"; });
} // namespace
