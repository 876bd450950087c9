// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Lattices of images and rectilinear grids: cells, values and planes by table, and lattice
// coordinates to double precision.
#include "StructuredGrids.h"

#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"

#include <cmath>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

std::vector<double> planesOf(const LatticeAxis& axis)
{
  std::vector<double> planes;
  for (int i = 0; i <= axis.Cells; ++i)
  {
    planes.push_back(axis.plane(i));
  }
  return planes;
}

struct Row
{
  LatticeCase Lies;
  int Cells;
  int Values;
  int FirstValue;
  bool Constant;
  std::vector<double> Uniform;     // planes of 4 points
  std::vector<double> Rectilinear; // planes of points 10, 11, 13, 19
};

const std::vector<Row>& table()
{
  const std::vector<double> points{ -1.5, -0.5, 0.5, 1.5 };
  const std::vector<double> centers{ -1.5, -1, 0, 1, 1.5 };
  // (x - 14.5) / 3
  const std::vector<double> rectilinear{ -1.5, -3.5 / 3, -0.5, 1.5 };
  const std::vector<double> between{ -1.5, -4.0 / 3, -2.5 / 3, 0.5, 1.5 };
  static const std::vector<Row> rows{
    { { false, Interpolation::Linear }, 3, 4, 0, false, points, rectilinear },
    { { false, Interpolation::Nearest }, 4, 4, 0, true, centers, between },
    { { true, Interpolation::Nearest }, 3, 3, 0, true, points, rectilinear },
    { { true, Interpolation::Linear }, 4, 3, -1, false, centers, between },
  };
  return rows;
}

TEST(Lattices, OfImagesByTable)
{
  for (const Row& row : table())
  {
    SCOPED_TRACE(nameOf(row.Lies));
    const Lattice lattice = latticeOf(imageOf(4, 2, 9), row.Lies);
    EXPECT_EQ(lattice.Constant, row.Constant);
    EXPECT_TRUE(lattice.isUniform());
    EXPECT_EQ(lattice.Axes[0].Cells, row.Cells);
    EXPECT_EQ(lattice.Axes[1].Cells, row.Cells - 2);
    EXPECT_EQ(lattice.Axes[2].Cells, row.Cells + 5);
    EXPECT_EQ(lattice.Axes[0].Values, row.Values);
    EXPECT_EQ(lattice.Axes[1].Values, row.Values - 2);
    EXPECT_EQ(lattice.Axes[2].Values, row.Values + 5);
    EXPECT_EQ(lattice.Axes[0].FirstValue, row.FirstValue);
    EXPECT_EQ(planesOf(lattice.Axes[0]), row.Uniform);
    EXPECT_EQ(planesOf(lattice.Axes[2]).front(), -4.0);
    EXPECT_EQ(planesOf(lattice.Axes[2]).back(), 4.0);
    EXPECT_EQ(
      lattice.numberOfCells(), std::uint64_t(row.Cells) * (row.Cells - 2) * (row.Cells + 5));
  }
}

TEST(Lattices, OfRectilinearGridsByTable)
{
  for (const Row& row : table())
  {
    for (const double sign : { 1.0, -1.0 }) // descending coordinates: ascending planes
    {
      SCOPED_TRACE(nameOf(row.Lies));
      const Lattice lattice =
        latticeOf(rectilinearOf(
                    { { { sign * 10, sign * 11, sign * 13, sign * 19 }, { 0, 1 }, { 0, 1, 3 } } }),
          row.Lies);
      EXPECT_FALSE(lattice.isUniform());
      const LatticeAxis& axis = lattice.Axes[0];
      EXPECT_EQ(axis.Cells, row.Cells);
      EXPECT_EQ(axis.Values, row.Values);
      EXPECT_EQ(axis.FirstValue, row.FirstValue);
      ASSERT_EQ(axis.Planes.size(), row.Rectilinear.size());
      for (std::size_t i = 0; i < row.Rectilinear.size(); ++i)
      {
        EXPECT_EQ(axis.Planes[i], static_cast<float>(row.Rectilinear[i])) << i;
      }
      EXPECT_EQ(lattice.FromNormalized[0] > 0, sign > 0);
    }
  }
}

// The middle of each gap for uniform coordinates: as an image has it.
TEST(Lattices, EvenCoordinatesAreAnImage)
{
  for (const LatticeCase& lies : latticeCases())
  {
    SCOPED_TRACE(nameOf(lies));
    const Lattice uneven =
      latticeOf(rectilinearOf({ { { 3, 5, 7, 9 }, { 1, 2 }, { 0, 1 } } }), lies);
    const Image image = imageOf(4, 2, 2);
    image->SetOrigin(3, 1, 0);
    image->SetSpacing(2, 1, 1);
    const Lattice even = latticeOf(image, lies);
    EXPECT_EQ(planesOf(uneven.Axes[0]), planesOf(even.Axes[0]));
    EXPECT_EQ(uneven.FromNormalized, even.FromNormalized);
  }
}

TEST(Lattices, TheFrameIsThatOfTheBox)
{
  const Image image = imageOf(3, 5, 2);
  image->SetOrigin(10, 20, 30);
  image->SetSpacing(2, -1, 4);
  for (const LatticeCase& lies : latticeCases())
  {
    const VolumeFrame frame = latticeOf(image, lies).Frame;
    EXPECT_EQ(frame.Center, (Vector3{ { 12, 18, 32 } }));
    EXPECT_DOUBLE_EQ(frame.Radius, std::sqrt(12.0));
    EXPECT_DOUBLE_EQ(frame.HalfExtent[2], 2 / std::sqrt(12.0));
  }
}

// A point of the data in lattice coordinates, in extended precision.
std::array<long double, 3> latticePlace(
  const Lattice& lattice, const std::array<long double, 3>& data)
{
  std::array<long double, 3> place;
  for (int r = 0; r < 3; ++r)
  {
    place[r] = lattice.FromNormalized[4 * r + 3];
    for (int k = 0; k < 3; ++k)
    {
      place[r] += lattice.FromNormalized[4 * r + k] *
                  ((data[k] - lattice.Frame.Center[k]) / lattice.Frame.Radius);
    }
  }
  return place;
}

// An oblique image with steps from 1e-3 to 250, one of them backwards: its direction is turned
// about x, z and y by 0.3, 1.1 and 2.0.
Image obliqueImage(const std::array<int, 3>& first)
{
  vtkNew<vtkMatrix3x3> direction;
  const auto turn = [&](int i, int j, double angle)
  {
    vtkNew<vtkMatrix3x3> rotation;
    rotation->SetElement(i, i, std::cos(angle));
    rotation->SetElement(i, j, -std::sin(angle));
    rotation->SetElement(j, i, std::sin(angle));
    rotation->SetElement(j, j, std::cos(angle));
    vtkMatrix3x3::Multiply3x3(rotation, direction, direction);
  };
  turn(1, 2, 0.3);
  turn(0, 1, 1.1);
  turn(2, 0, 2.0);
  const auto image = Image::New();
  image->SetExtent(first[0], first[0] + 99, first[1], first[1] + 15, first[2], first[2] + 39);
  image->SetOrigin(1e6, -3e6, 2e6);
  image->SetSpacing(1e-3, -0.7, 250);
  image->SetDirectionMatrix(direction);
  return image;
}

// As exact as double precision of a place in the box, however far from 0 this is, and wherever the
// extent begins.
TEST(Lattices, ImagesFarFromZero)
{
  std::mt19937 random(8);
  for (const std::array<int, 3>& first :
    { std::array<int, 3>{ { 0, 0, 0 } }, { { -70, 1000, 5 } }, { { 1 << 30, -70000, 12005 } } })
  {
    const Image image = obliqueImage(first);
    const Lattice lattice = latticeOf(image, { false, Interpolation::Linear });
    const vtkMatrix4x4* matrix = image->GetIndexToPhysicalMatrix();
    for (int n = 0; n < 1000; ++n)
    {
      const std::array<long double, 3> place{ { uniform(random) * 99 - 49.5,
        uniform(random) * 15 - 7.5, uniform(random) * 39 - 19.5 } };
      const std::array<long double, 3> numbers{ { first[0] + 49.5L + place[0],
        first[1] + 7.5L + place[1], first[2] + 19.5L + place[2] } };
      std::array<long double, 3> data;
      for (int k = 0; k < 3; ++k)
      {
        data[k] = matrix->GetElement(k, 3);
        for (int a = 0; a < 3; ++a)
        {
          data[k] += matrix->GetElement(k, a) * numbers[a];
        }
      }
      const auto found = latticePlace(lattice, data);
      for (int a = 0; a < 3; ++a)
      {
        // The box is 39 steps of 250 long: so many steps along each axis.
        const double size = 1e4 / std::abs(image->GetSpacing()[a]);
        EXPECT_NEAR(static_cast<double>(found[a] - place[a]), 0, 2.3e-16 * (size + 100)) << a;
      }
    }
  }
}

TEST(Lattices, CoordinatesFarFromZero)
{
  std::array<std::vector<double>, 3> coordinates;
  for (int i = 0; i < 50; ++i)
  {
    coordinates[0].push_back(1e6 + 1e-3 * (i + 0.3 * std::sin(i)));
    coordinates[1].push_back(-1e6 - 250 * (i + 0.3 * std::sin(2 * i)));
    coordinates[2].push_back(i);
  }
  const Lattice lattice = latticeOf(rectilinearOf(coordinates), { false, Interpolation::Linear });
  for (int i = 0; i < 50; ++i)
  {
    const auto found =
      latticePlace(lattice, { { coordinates[0][i], coordinates[1][i], coordinates[2][i] } });
    for (int a = 0; a < 3; ++a)
    {
      const std::vector<double>& line = coordinates[a];
      const long double mean = (static_cast<long double>(line.back()) - line.front()) / 49;
      const long double exact =
        (line[i] - (static_cast<long double>(line.front()) + line.back()) / 2) / mean;
      EXPECT_NEAR(static_cast<double>(found[a] - exact), 0, 2e-14) << a << ", " << i;
      EXPECT_NEAR(lattice.Axes[a].plane(i), static_cast<double>(exact), 2e-6) << a << ", " << i;
    }
  }
}
} // namespace
