// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattices.h"

#include "Grids.h"
#include "KeptCells.h"
#include "Numbers.h"

#include <cmath>
#include <map>

namespace tetmarch::bench
{
namespace
{
constexpr double Jitter = 0.15;
constexpr unsigned Seed = 1;

Dataset makeLattice(int size, const testing::Field& field)
{
  Dataset dataset;
  dataset.Array = "f";
  dataset.Grid = withOnly(testing::jitteredLattice(size, Jitter, Seed, field), dataset.Array);
  dataset.Range = { 0.0, 1.0, 0.25 };
  return dataset;
}

constexpr double Waves = 2.5; // along an edge: the scalar turns several times

/// A ray through the cube is absorbed by about three quarters.
Dataset makeWaves(int size)
{
  Dataset dataset = makeLattice(size, testing::sineField(Waves));
  dataset.Own = wavesProperty(dataset.Range.UnitDistance);
  return dataset;
}

/// The same with 216 holes, each about a third of what lies around it: rays leave and enter again
/// many times.
Dataset makeCheese(int size)
{
  constexpr double holes = 6.0; // along an edge
  constexpr double radius = 0.42 / holes;
  Dataset dataset = makeWaves(size);
  dataset.Grid = keepCells(dataset.Grid,
    [grid = dataset.Grid](vtkIdList* points)
    {
      const auto p = centerOf(grid, points);
      const auto along = [&](int k) { return p[k] - (std::floor(holes * p[k]) + 0.5) / holes; };
      return std::hypot(along(0), along(1), along(2)) > radius;
    });
  return dataset;
}

/// Every twentieth cube is cut into eight: one face of ten has hanging nodes.
Dataset makeHanging(int size)
{
  Dataset dataset = makeWaves(1);
  dataset.Grid =
    withOnly(testing::refinedCubes(size, 20, Seed, testing::sineField(Waves)), dataset.Array);
  return dataset;
}

/// From 0 to 1 within a fiftieth of the cube's edge, across a sphere with bumps.
double front(double x, double y, double z)
{
  constexpr double thickness = 0.02;
  constexpr double radius = 0.36;
  constexpr double bumps = 0.05;
  constexpr double frequency = 25.0;
  const double distance =
    std::hypot(x - 0.5, y - 0.5, z - 0.5) - radius -
    bumps * std::sin(frequency * x) * std::sin(frequency * y) * std::sin(frequency * z);
  return 0.5 + 0.5 * std::tanh(distance / (0.5 * thickness));
}

Dataset makeFront(int size) { return makeLattice(size, front); }

/// One wave an edge, for pictures that approach that of the field as the mesh is refined.
Dataset makeRefined(int size)
{
  const testing::Field field = testing::sineField(1.0);
  Dataset dataset = makeLattice(size, field);
  dataset.Exact = field;
  return dataset;
}

struct Lattice
{
  Dataset (*Make)(int size);
  int Size; // cubes along an edge
};

/// Nothing if the name isn't one of a lattice.
std::optional<Lattice> latticeOf(const std::string& name)
{
  static const std::map<std::string, Lattice> named = { { "lattice162k", { makeWaves, 30 } },
    { "lattice1.3m", { makeWaves, 60 } }, { "lattice6m", { makeWaves, 100 } },
    { "front1.3m", { makeFront, 60 } }, { "cheese", { makeCheese, 60 } } };
  static const std::map<std::string, Dataset (*)(int)> families = { { "lattice", makeWaves },
    { "cheese", makeCheese }, { "hanging", makeHanging }, { "front", makeFront },
    { "refined", makeRefined } };
  const auto found = named.find(name);
  if (found != named.end())
  {
    return found->second;
  }
  const auto colon = name.find(':');
  const auto family = families.find(name.substr(0, colon));
  if (colon == std::string::npos || family == families.end())
  {
    return std::nullopt;
  }
  const auto size = ParseInteger(name.substr(colon + 1));
  return size && *size > 0 ? std::optional<Lattice>({ family->second, *size }) : std::nullopt;
}
} // namespace

bool isLattice(const std::string& name) { return latticeOf(name).has_value(); }

Dataset makeLattice(const std::string& name)
{
  const Lattice lattice = latticeOf(name).value();
  return lattice.Make(lattice.Size);
}
} // namespace tetmarch::bench
