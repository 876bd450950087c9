// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "DatasetReader.h"
#include "Grids.h"
#include "Numbers.h"
#include "TransferFunctionPreset.h"

#include "vtkNew.h"

#include <map>
#include <optional>

namespace tetmarch::bench
{
namespace
{
const std::string GolfBall = "golfball";
const std::string AnyLattice = "lattice:";

/// The number of cubes along an edge; nothing if the name isn't one of a lattice.
std::optional<int> latticeSize(const std::string& name)
{
  static const std::map<std::string, int> named = { { "lattice162k", 30 }, { "lattice1.3m", 60 },
    { "lattice6m", 100 } };
  const auto found = named.find(name);
  if (found != named.end())
  {
    return found->second;
  }
  if (name.compare(0, AnyLattice.size(), AnyLattice) != 0)
  {
    return std::nullopt;
  }
  const auto size = ParseInteger(name.substr(AnyLattice.size()));
  return size && *size > 0 ? size : std::nullopt;
}

vtkSmartPointer<vtkVolumeProperty> makeProperty(
  const TransferFunctions& functions, double unitDistance)
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetColor(functions.Color);
  property->SetScalarOpacity(functions.Opacity);
  property->SetScalarOpacityUnitDistance(unitDistance);
  property->SetInterpolationTypeToLinear();
  property->ShadeOff();
  return property;
}

/// Translucent throughout, so that no ray may end early: a ray through the unit cube is absorbed by
/// about three quarters. Two and a half waves an edge make the scalar turn several times along it.
Scene makeLattice(int size)
{
  constexpr double jitter = 0.15;
  constexpr unsigned seed = 1;
  constexpr double waves = 2.5;
  constexpr double unitDistance = 0.25;
  Scene scene;
  scene.Grid = testing::jitteredLattice(size, jitter, seed, testing::sineField(waves));
  scene.Array = "f";
  TransferFunctions functions;
  functions.Color->AddRGBPoint(0.0, 0.1, 0.2, 0.8);
  functions.Color->AddRGBPoint(0.5, 0.9, 0.9, 0.9);
  functions.Color->AddRGBPoint(1.0, 0.8, 0.1, 0.1);
  functions.Opacity->AddPoint(0.0, 0.6);
  functions.Opacity->AddPoint(0.3, 0.1);
  functions.Opacity->AddPoint(0.5, 0.4);
  functions.Opacity->AddPoint(0.7, 0.1);
  functions.Opacity->AddPoint(1.0, 0.8);
  scene.Property = makeProperty(functions, unitDistance);
  return scene;
}

/// The scene of the demo.
Scene makeGolfBall(const std::string& folder)
{
  constexpr double unitDistance = 0.02;
  Scene scene;
  scene.Grid = ReadUnstructuredGrid(folder + "/golfball_small.vtu", std::nullopt);
  scene.Array = "vorticity_mag";
  scene.Property = makeProperty(ReadPreset(folder + "/golfball_wake.json"), unitDistance);
  return scene;
}
} // namespace

bool isDataset(const std::string& name)
{
  return name == GolfBall || latticeSize(name).has_value();
}

Scene makeScene(const std::string& dataset, const std::string& dataFolder)
{
  const auto size = latticeSize(dataset);
  return size ? makeLattice(*size) : makeGolfBall(dataFolder);
}
} // namespace tetmarch::bench
