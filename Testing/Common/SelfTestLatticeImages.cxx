// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The small images and rectilinear grids are where they are said to be, and have the values.
#include "Fields.h"
#include "LatticeImages.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace
{
using namespace tetmarch::testing;

TEST(LatticeImages, PlacesHaveDifferentNamesAndVolume)
{
  std::set<std::string> names;
  for (const ImagePlace& place : imagePlaces())
  {
    EXPECT_TRUE(names.insert(place.Name).second) << place.Name;
    const auto image = imageOf(linearField(), place);
    EXPECT_EQ(image->GetDataDimension(), 3) << place.Name;
    // The first and the last point of the field's cube.
    vtkDataArray* f = image->GetPointData()->GetScalars();
    EXPECT_EQ(f->GetNumberOfTuples(), image->GetNumberOfPoints());
    EXPECT_EQ(f->GetComponent(0, 0), 0.0);
    EXPECT_NEAR(f->GetComponent(f->GetNumberOfTuples() - 1, 0), 1.0, 1e-15);
    EXPECT_EQ(image->GetCellData()->GetScalars()->GetNumberOfTuples(), image->GetNumberOfCells());
    double first[3];
    image->GetPoint(0, first);
    const int* e = image->GetExtent();
    for (int a = 0; a < 3; ++a)
    {
      double expected = place.Origin[a];
      for (int k = 0; k < 3; ++k)
      {
        expected += place.Direction[3 * a + k] * place.Spacing[k] * e[2 * k];
      }
      EXPECT_NEAR(first[a], expected, 1e-12 * (1.0 + std::abs(expected))) << place.Name;
    }
  }
  EXPECT_EQ(names.size(), 11u);
}

TEST(LatticeImages, CellsHaveTheFieldOfTheirMiddle)
{
  // Linear: the mean of the points.
  const auto image = imageOf(linearField(), imagePlaces().back());
  const auto grid = rectilinearOf(linearField());
  for (vtkDataSet* data : { static_cast<vtkDataSet*>(image), static_cast<vtkDataSet*>(grid) })
  {
    for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
    {
      vtkIdList* points = data->GetCell(c)->GetPointIds();
      double mean = 0.0;
      for (vtkIdType i = 0; i < 8; ++i)
      {
        mean += 0.125 * data->GetPointData()->GetScalars()->GetComponent(points->GetId(i), 0);
      }
      EXPECT_NEAR(data->GetCellData()->GetScalars()->GetComponent(c, 0), mean, 1e-15);
    }
  }
}

TEST(LatticeImages, RectilinearAxesAscendAndAreUneven)
{
  for (const AxisCoordinates& axes : rectilinearAxes())
  {
    for (const std::vector<double>& axis : axes.Axes)
    {
      ASSERT_GE(axis.size(), 2u);
      for (std::size_t i = 1; i < axis.size(); ++i)
      {
        EXPECT_GT(axis[i], axis[i - 1]) << axes.Name;
      }
    }
    EXPECT_GT(rectilinearOf(linearField(), axes)->GetLength(), 0.0);
  }
  const AxisCoordinates uneven = unevenCube(20);
  double least = 1.0;
  double greatest = 0.0;
  for (std::size_t i = 1; i <= 20; ++i)
  {
    least = std::min(least, uneven.Axes[0][i] - uneven.Axes[0][i - 1]);
    greatest = std::max(greatest, uneven.Axes[0][i] - uneven.Axes[0][i - 1]);
  }
  EXPECT_GT(greatest, 4.0 * least);
  EXPECT_LE(greatest, 10.0 * least);
}

TEST(LatticeImages, EveryTypeHasTheRange)
{
  std::set<int> types;
  for (const int type : numberTypes())
  {
    types.insert(type);
    const auto image = imageOf(linearField());
    convertScalars(image, type);
    vtkDataArray* f = image->GetPointData()->GetScalars();
    EXPECT_EQ(f->GetDataType(), type);
    EXPECT_STREQ(f->GetName(), "f");
    double range[2];
    f->GetRange(range);
    EXPECT_EQ(range[0], rangeInType(type)[0]) << f->GetDataTypeAsString();
    EXPECT_NEAR(range[1], rangeInType(type)[1], 1e-15 * range[1]) << f->GetDataTypeAsString();
    EXPECT_EQ(image->GetCellData()->GetScalars()->GetDataType(), type);
  }
  EXPECT_EQ(types.size(), 14u);
}

TEST(LatticeImages, MarkedAndSpoiltAreThoseAskedFor)
{
  const auto image = imageOf(linearField(), unitCube(3));
  const auto odd = [](vtkIdType id) { return id % 2 == 1; };
  markPoints(image, vtkDataSetAttributes::HIDDENPOINT, odd);
  markCells(image, vtkDataSetAttributes::HIDDENCELL, odd);
  markCells(image, vtkDataSetAttributes::DUPLICATECELL, [](vtkIdType id) { return id == 3; });
  for (vtkIdType i = 0; i < 27; ++i)
  {
    EXPECT_EQ(image->IsPointVisible(i), i % 2 == 0);
    const double ghost =
      image->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName())->GetComponent(i, 0);
    EXPECT_EQ(ghost,
      (i % 2) * vtkDataSetAttributes::HIDDENCELL + (i == 3) * vtkDataSetAttributes::DUPLICATECELL);
  }
  spoilScalars(image, odd, [](vtkIdType id) { return id == 4; });
  EXPECT_TRUE(std::isnan(image->GetPointData()->GetScalars()->GetComponent(1, 0)));
  EXPECT_FALSE(std::isnan(image->GetPointData()->GetScalars()->GetComponent(2, 0)));
  EXPECT_TRUE(std::isnan(image->GetCellData()->GetScalars()->GetComponent(4, 0)));
  EXPECT_FALSE(std::isnan(image->GetCellData()->GetScalars()->GetComponent(5, 0)));
}

TEST(LatticeImages, FieldsAreAsTheySay)
{
  EXPECT_EQ(productField()(0.5, 0.5, 0.5), 0.125);
  const Field aslant = linearFieldAlong(1.0, -2.0, 0.5);
  EXPECT_NEAR(aslant(0.0, 1.0, 0.0), 0.0, 1e-15);
  EXPECT_NEAR(aslant(1.0, 0.0, 1.0), 1.0, 1e-15);
  // By the formulas of the paper at a place where they are simple: r = 0, z = 0, and z = 1.
  EXPECT_NEAR(marschnerLobbField()(0.5, 0.5, 0.5), 1.5 / 2.5, 1e-15);
  EXPECT_NEAR(marschnerLobbField()(0.5, 0.5, 1.0), 0.5 / 2.5, 1e-15);
  EXPECT_EQ(stepField()(0.49, 1.0, 1.0), 0.0);
  EXPECT_EQ(stepField()(0.5, 0.0, 0.0), 1.0);
  EXPECT_EQ(checkerboardField(4)(0.25, 0.5, 0.5), 1.0);
  EXPECT_EQ(checkerboardField(4)(0.25, 0.75, 0.5), 0.0);
}
} // namespace
