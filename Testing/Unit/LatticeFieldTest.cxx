// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The field that a lattice stands for, against its definition in coordinates of the data.
#include "StructuredGrids.h"

#include <algorithm>
#include <cmath>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// What the value of a place is, by definition. Numbers count from 0, as fractions between points.
double fieldOf(const LatticeCase& lies, const std::array<int, 3>& points,
  const std::vector<double>& values, const std::array<std::array<double, 2>, 3>& coordinates)
{
  const int shrink = lies.OfCells ? 1 : 0;
  std::array<int, 3> low;
  std::array<double, 3> share;
  for (int a = 0; a < 3; ++a)
  {
    const int last = points[a] - 1 - shrink;
    // The place between values, and its nearest value.
    low[a] = std::clamp(static_cast<int>(std::floor(coordinates[a][0])), 0, last);
    share[a] = std::clamp(coordinates[a][0] - low[a], 0.0, 1.0);
    if (lies.Between == Interpolation::Nearest)
    {
      low[a] = std::clamp(static_cast<int>(coordinates[a][1]), 0, last);
      share[a] = 0;
    }
  }
  double sum = 0;
  for (int c = 0; c < 8; ++c)
  {
    double weight = 1;
    std::array<int, 3> at;
    for (int a = 0; a < 3; ++a)
    {
      const bool upper = (c >> a & 1) != 0;
      weight *= upper ? share[a] : 1 - share[a];
      at[a] = std::min(low[a] + (upper ? 1 : 0), points[a] - 1 - shrink);
    }
    sum +=
      weight *
      values[(std::size_t(at[2]) * (points[1] - shrink) + at[1]) * (points[0] - shrink) + at[0]];
  }
  return sum;
}

// The value of a place as a ray finds it: by lattice coordinates, planes and values.
double fieldOf(const Lattice& lattice, const std::vector<double>& values, const Vector3& place)
{
  std::array<std::array<int, 2>, 3> ends;
  std::array<double, 3> share;
  for (int a = 0; a < 3; ++a)
  {
    const LatticeAxis& axis = lattice.Axes[a];
    int cell = 0;
    while (cell + 1 < axis.Cells && axis.plane(cell + 1) <= place[a])
    {
      ++cell;
    }
    share[a] = lattice.Constant
                 ? 0
                 : (place[a] - axis.plane(cell)) / (axis.plane(cell + 1) - axis.plane(cell));
    for (int e = 0; e < 2; ++e)
    {
      ends[a][e] = std::clamp(cell + axis.FirstValue + e, 0, axis.Values - 1);
    }
  }
  double sum = 0;
  for (int c = 0; c < 8; ++c)
  {
    double weight = 1;
    std::array<int, 3> at;
    for (int a = 0; a < 3; ++a)
    {
      const int e = c >> a & 1;
      weight *= e != 0 ? share[a] : 1 - share[a];
      at[a] = ends[a][e];
    }
    sum += weight *
           values[(std::size_t(at[2]) * lattice.Axes[1].Values + at[1]) * lattice.Axes[0].Values +
                  at[0]];
  }
  return sum;
}

std::vector<double> randomValues(const Lattice& lattice, std::mt19937& random)
{
  std::vector<double> values(lattice.numberOfValues());
  for (double& value : values)
  {
    value = uniform(random);
  }
  return values;
}

// The place's number, as a fraction, among values along an axis (first), and the number of the
// value in whose region it is (second).
std::array<double, 2> numbersOf(
  const LatticeCase& lies, const std::vector<double>& points, double x)
{
  std::vector<double> centers;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    centers.push_back((points[i - 1] + points[i]) / 2);
  }
  const auto numberAmong = [x](const std::vector<double>& places)
  {
    std::size_t i = 0;
    while (i + 2 < places.size() && x > places[i + 1])
    {
      ++i;
    }
    return places.size() < 2 ? 0 : double(i) + (x - places[i]) / (places[i + 1] - places[i]);
  };
  const double region =
    lies.OfCells ? std::floor(numberAmong(points))
                 : double(std::upper_bound(centers.begin(), centers.end(), x) - centers.begin());
  return { { numberAmong(lies.OfCells ? centers : points), region } };
}

// Random places of a rectilinear grid, whose lattice coordinates are planes of float.
TEST(LatticeFields, FieldsOfRectilinearGrids)
{
  std::mt19937 random(3);
  std::array<std::vector<double>, 3> coordinates;
  for (int a = 0; a < 3; ++a)
  {
    double x = 100;
    for (int i = 0; i < 4 + 3 * a; ++i)
    {
      coordinates[a].push_back(x += 0.1 + uniform(random));
    }
  }
  const std::array<int, 3> points{ { 4, 7, 10 } };
  for (const LatticeCase& lies : latticeCases())
  {
    SCOPED_TRACE(nameOf(lies));
    const Lattice lattice = latticeOf(rectilinearOf(coordinates), lies);
    const std::vector<double> values = randomValues(lattice, random);
    for (int n = 0; n < 2000; ++n)
    {
      std::array<std::array<double, 2>, 3> numbers;
      Vector3 place;
      for (int a = 0; a < 3; ++a)
      {
        const std::vector<double>& line = coordinates[a];
        const double x = line.front() + uniform(random) * (line.back() - line.front());
        numbers[a] = numbersOf(lies, line, x);
        const double normalized = (x - lattice.Frame.Center[a]) / lattice.Frame.Radius;
        place[a] = lattice.FromNormalized[5 * a] * normalized + lattice.FromNormalized[4 * a + 3];
      }
      EXPECT_NEAR(fieldOf(lattice, values, place), fieldOf(lies, points, values, numbers), 3e-6);
    }
  }
}

TEST(LatticeFields, FieldsOfImages)
{
  std::mt19937 random(4);
  const std::array<int, 3> points{ { 5, 3, 2 } };
  for (const LatticeCase& lies : latticeCases())
  {
    SCOPED_TRACE(nameOf(lies));
    const Lattice lattice = latticeOf(imageOf(5, 3, 2), lies);
    const std::vector<double> values = randomValues(lattice, random);
    for (int n = 0; n < 2000; ++n)
    {
      std::array<std::array<double, 2>, 3> numbers;
      Vector3 place;
      for (int a = 0; a < 3; ++a)
      {
        std::vector<double> line;
        for (int i = 0; i < points[a]; ++i)
        {
          line.push_back(i);
        }
        const double x = uniform(random) * (points[a] - 1);
        numbers[a] = numbersOf(lies, line, x);
        place[a] = x - 0.5 * (points[a] - 1);
      }
      EXPECT_NEAR(fieldOf(lattice, values, place), fieldOf(lies, points, values, numbers), 1e-13);
    }
  }
}
} // namespace
