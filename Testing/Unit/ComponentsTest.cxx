// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which components of an array are drawn together, how they are stored, and the errors of those
// that can't be.
#include "Appearance/Components.h"
#include "Mesh/MeshScalars.h"

#include "ComponentFields.h"
#include "UnitMeshes.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

class DrawnTogether : public ::testing::Test
{
protected:
  DrawnScalars drawn(int components, VectorMode mode, int type = VTK_DOUBLE)
  {
    this->Array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    this->Array->SetName("a");
    this->Array->SetNumberOfComponents(components);
    DrawnScalars drawn;
    this->Error = chooseScalars(this->Grid, this->Array, false, { mode, 0 }, this->Property, drawn);
    return drawn;
  }

  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkUnstructuredGrid> Grid; // without points, like the array
  vtkSmartPointer<vtkDataArray> Array;
  std::string Error;
};

TEST_F(DrawnTogether, OneUnlessAsked)
{
  for (int components = 1; components <= 6; ++components)
  {
    for (const VectorMode mode :
      { VectorMode::Disabled, VectorMode::Magnitude, VectorMode::Component })
    {
      EXPECT_EQ(this->drawn(components, mode).Mix, ComponentMix::Single);
      EXPECT_EQ(this->Error, "");
    }
  }
  EXPECT_EQ(this->drawn(1, VectorMode::AllComponents).Mix, ComponentMix::Single);
  this->Property->IndependentComponentsOff();
  EXPECT_EQ(this->drawn(1, VectorMode::AllComponents).Mix, ComponentMix::Single);
  EXPECT_EQ(this->drawn(1, VectorMode::Disabled).Mix, ComponentMix::Single);
  for (int components = 2; components <= 6; ++components)
  {
    EXPECT_EQ(this->drawn(components, VectorMode::Magnitude).Mix, ComponentMix::Single);
    EXPECT_EQ(this->drawn(components, VectorMode::Component).Mix, ComponentMix::Single);
    EXPECT_EQ(this->Error, "");
  }
}

TEST_F(DrawnTogether, IndependentOnes)
{
  for (int components = 2; components <= 4; ++components)
  {
    const DrawnScalars drawn = this->drawn(components, VectorMode::AllComponents);
    EXPECT_EQ(drawn.Mix, ComponentMix::Independent);
    EXPECT_EQ(drawn.First.Component, 0);
    EXPECT_EQ(drawn.Extra.size(), std::size_t(components) - 1);
    EXPECT_EQ(drawn.Extra.back(), components - 1);
    EXPECT_EQ(this->Error, "");
  }
  this->drawn(5, VectorMode::AllComponents);
  EXPECT_NE(this->Error.find("\"a\" has 5 components, but at most 4"), std::string::npos)
    << this->Error;
}

TEST_F(DrawnTogether, DependentOnes)
{
  this->Property->IndependentComponentsOff();
  for (const VectorMode mode : { VectorMode::Disabled, VectorMode::AllComponents })
  {
    const DrawnScalars two = this->drawn(2, mode);
    EXPECT_EQ(two.Mix, ComponentMix::ColorAndOpacity);
    EXPECT_EQ(two.First.Component, 1);
    EXPECT_EQ(two.Extra, std::vector<int>{ 0 });
    EXPECT_EQ(two.ExtraUnit, 0);
    const DrawnScalars four = this->drawn(4, mode);
    EXPECT_EQ(four.Mix, ComponentMix::DirectColor);
    EXPECT_EQ(four.First.Component, 3);
    EXPECT_EQ(four.Extra, (std::vector<int>{ 0, 1, 2 }));
    EXPECT_EQ(four.ExtraUnit, 1);
    EXPECT_EQ(this->drawn(4, mode, VTK_FLOAT).ExtraUnit, 1);
    for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_LONG_LONG })
    {
      EXPECT_EQ(this->drawn(4, mode, type).ExtraUnit, 255);
    }
    for (const int components : { 3, 5, 9 })
    {
      this->drawn(components, mode);
      EXPECT_NE(this->Error.find("\"a\" has " + std::to_string(components) + " components"),
        std::string::npos)
        << this->Error;
      EXPECT_NE(this->Error.find("either 2"), std::string::npos) << this->Error;
    }
  }
}

// Stored scalars say what was in the array.
TEST(ReadScalars, ValuesComeBack)
{
  for (const bool cells : { false, true })
  {
    const auto fields = componentFields(4);
    const Grid grid = withComponents(jitteredLattice(3), fields, VTK_FLOAT);
    vtkDataArray* array =
      cells ? grid->GetCellData()->GetScalars() : grid->GetPointData()->GetScalars();
    TetMesh mesh = built(grid);
    const DrawnScalars drawn{ array, cells, ComponentMix::Independent, { false, 2 }, { 3, 0 } };
    const MeshScalars scalars = readScalars(grid, drawn, mesh);
    const ScalarRange& range = scalars.Range;
    EXPECT_TRUE(range.AllFinite);
    ASSERT_EQ(scalars.Extra.count(), 2u);
    const std::size_t count = cells ? mesh.Tets.size() : mesh.Vertices.size();
    ASSERT_EQ(scalars.Extra.Values.size(), 2 * count);
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto value = [](const ScalarRange& r, float stored)
      { return r.Low + r.width() * double(stored); };
      const double first = value(range, cells ? scalars.OfCells[i] : mesh.Vertices[i].Scalar);
      EXPECT_NEAR(
        first, array->GetComponent((cells ? mesh.TetCells[i] : mesh.VertexPoints[i]), 2), 1e-6);
      for (std::size_t k = 0; k < 2; ++k)
      {
        EXPECT_NEAR(value(scalars.Extra.Ranges[k], scalars.Extra.Values[2 * i + k]),
          array->GetComponent((cells ? mesh.TetCells[i] : mesh.VertexPoints[i]), drawn.Extra[k]),
          1e-6);
      }
    }
  }
}

TEST(ReadScalars, ColorsAreClampedAndNotStretched)
{
  const Grid grid = withComponents(singleTet(), componentFields(4), VTK_DOUBLE);
  vtkDataArray* array = grid->GetPointData()->GetScalars();
  array->SetTuple4(0, -0.5, 0.25, 1.5, 7.0);
  array->SetTuple4(1, 0.5, 0.25, 0.75, 9.0);
  TetMesh mesh = built(grid);
  const DrawnScalars drawn{ array, false, ComponentMix::DirectColor, { false, 3 }, { 0, 1, 2 }, 1 };
  const MeshScalars scalars = readScalars(grid, drawn, mesh);
  EXPECT_EQ(scalars.Range.High, 9);
  for (std::size_t i = 0; i < mesh.VertexPoints.size(); ++i)
  {
    const float* color = &scalars.Extra.Values[3 * i];
    if (mesh.VertexPoints[i] == 0)
    {
      EXPECT_EQ(color[0], 0.0f);
      EXPECT_EQ(color[1], 0.25f);
      EXPECT_EQ(color[2], 1.0f);
    }
    if (mesh.VertexPoints[i] == 1)
    {
      EXPECT_EQ(color[0], 0.5f);
      EXPECT_EQ(color[2], 0.75f);
    }
  }
}

TEST(ReadScalars, OneThatIsNotFiniteHidesAll)
{
  for (const bool cells : { false, true })
  {
    const Grid grid = withComponents(twoTetsSharingFace(), componentFields(3), VTK_DOUBLE);
    vtkDataArray* array =
      cells ? grid->GetCellData()->GetScalars() : grid->GetPointData()->GetScalars();
    array->SetComponent(1, 2, std::numeric_limits<double>::quiet_NaN());
    TetMesh mesh = built(grid);
    const DrawnScalars drawn{ array, cells, ComponentMix::Independent, {}, { 1, 2 } };
    const MeshScalars scalars = readScalars(grid, drawn, mesh);
    EXPECT_FALSE(scalars.Range.AllFinite);
    EXPECT_TRUE(scalars.Extra.Ranges[1].AllFinite == false);
    for (std::size_t i = 0; i < (cells ? mesh.Tets.size() : mesh.Vertices.size()); ++i)
    {
      const float stored = cells ? scalars.OfCells[i] : mesh.Vertices[i].Scalar;
      EXPECT_EQ(stored == UndrawnScalar, (cells ? mesh.TetCells[i] : mesh.VertexPoints[i]) == 1);
    }
  }
}

TEST(ComponentFactors, AreWeightsByUnitDistances)
{
  vtkNew<vtkVolumeProperty> property;
  setComponentFunctions(property, 3);
  Components parts;
  parts.Mix = ComponentMix::Independent;
  parts.ExtraRanges.resize(2);
  ASSERT_EQ(setFactors(property, parts), "");
  EXPECT_DOUBLE_EQ(parts.Factors[0], 1.0);
  EXPECT_DOUBLE_EQ(parts.Factors[1], 0.8 / 1.5);
  EXPECT_DOUBLE_EQ(parts.Factors[2], 0.6 / 2.0);
  property->SetScalarOpacityUnitDistance(2, 0.0);
  EXPECT_NE(setFactors(property, parts).find("component 2 is 0"), std::string::npos);
  parts.Mix = ComponentMix::DirectColor;
  EXPECT_EQ(setFactors(property, parts), "");
}
} // namespace
