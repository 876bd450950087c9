// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Datasets.h"

#include "DatasetReader.h"
#include "Failure.h"
#include "Grids.h"
#include "KeptCells.h"
#include "Numbers.h"
#include "TransferFunctionPreset.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

namespace tetmarch::bench
{
namespace
{
constexpr double Jitter = 0.15;
constexpr unsigned Seed = 1;

/// What is read from a file: the array, and the range of functions that shows something of it.
struct File
{
  std::string DataFolders::*Folder;
  const char* Path;
  const char* Array;
  FunctionRange Range;
};

const std::map<std::string, File>& filesByName()
{
  // Vorticity is greatest at the wall by far, where it would be all that is seen.
  static const std::map<std::string, File> files = {
    { "golfball",
      { &DataFolders::Own, "golfball_small.vtu", "vorticity_mag", { 0.0, 10.0, 0.2 } } },
    { "golfball-medium", { &DataFolders::Others, "golfball/golfball_medium.vtu", "vorticity_mag",
                           { 0.0, 10.0, 0.2 } } },
    { "bluntfin",
      { &DataFolders::Others, "unstructured/bluntfin.vtu", "Density", { 0.19, 4.98, 2.0 } } },
    { "oxygen", { &DataFolders::Others, "unstructured/oxygen_post.vtu", "VelocityMagnitude",
                  { 0.0, 1.4, 2.0 } } },
  };
  return files;
}

std::string pathOf(const File& file, const DataFolders& folders)
{
  return folders.*file.Folder + "/" + file.Path;
}

vtkSmartPointer<vtkVolumeProperty> propertyOf(const TransferFunctions& functions, double unit)
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetColor(functions.Color);
  property->SetScalarOpacity(functions.Opacity);
  property->SetScalarOpacityUnitDistance(unit);
  property->SetInterpolationTypeToLinear();
  property->ShadeOff();
  return property;
}

vtkSmartPointer<vtkUnstructuredGrid> withOnly(vtkUnstructuredGrid* grid, const std::string& array)
{
  vtkDataArray* kept = grid->GetPointData()->GetArray(array.c_str());
  if (!kept)
  {
    throw Failure("there is no point array " + array);
  }
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->CopyStructure(grid);
  result->GetPointData()->SetScalars(kept);
  return result;
}

Dataset read(const std::string& name, const File& file, const DataFolders& folders)
{
  constexpr double demoUnitDistance = 0.02;
  Dataset dataset;
  dataset.Grid = withOnly(ReadUnstructuredGrid(pathOf(file, folders), std::nullopt), file.Array);
  dataset.Array = file.Array;
  dataset.Range = file.Range;
  if (name == "golfball")
  {
    dataset.Own = propertyOf(ReadPreset(folders.Own + "/golfball_wake.json"), demoUnitDistance);
  }
  return dataset;
}

Dataset readGolfBall(const DataFolders& folders)
{
  return read("golfball", filesByName().at("golfball"), folders);
}

/// A slab of the golf ball's flow, a few cells thick: most of its cells are at the boundary.
Dataset readSlab(const DataFolders& folders)
{
  constexpr double halfThickness = 0.06;
  Dataset dataset = readGolfBall(folders);
  dataset.Grid = keepCells(dataset.Grid, [grid = dataset.Grid](vtkIdList* points)
    { return std::abs(centerOf(grid, points)[2]) < halfThickness; });
  return dataset;
}

/// The cells of the golf ball's flow in which the vorticity reaches 1: the wake, in ragged parts.
Dataset readWake(const DataFolders& folders)
{
  Dataset dataset = readGolfBall(folders);
  vtkDataArray* vorticity = dataset.Grid->GetPointData()->GetArray(dataset.Array.c_str());
  dataset.Grid = keepCells(dataset.Grid,
    [vorticity](vtkIdList* points)
    {
      return std::any_of(points->begin(), points->end(),
        [&](vtkIdType point) { return vorticity->GetTuple1(point) >= 1.0; });
    });
  return dataset;
}

/// Meshes that are parts of the golf ball's.
const std::map<std::string, Dataset (*)(const DataFolders&)>& partsByName()
{
  static const std::map<std::string, Dataset (*)(const DataFolders&)> parts = {
    { "golfball-slab", readSlab }, { "golfball-wake", readWake }
  };
  return parts;
}

/// Translucent throughout, so that no ray may end early: a ray through the unit cube is absorbed by
/// about three quarters.
vtkSmartPointer<vtkVolumeProperty> latticeProperty(double unitDistance)
{
  TransferFunctions functions;
  functions.Color->AddRGBPoint(0.0, 0.1, 0.2, 0.8);
  functions.Color->AddRGBPoint(0.5, 0.9, 0.9, 0.9);
  functions.Color->AddRGBPoint(1.0, 0.8, 0.1, 0.1);
  functions.Opacity->AddPoint(0.0, 0.6);
  functions.Opacity->AddPoint(0.3, 0.1);
  functions.Opacity->AddPoint(0.5, 0.4);
  functions.Opacity->AddPoint(0.7, 0.1);
  functions.Opacity->AddPoint(1.0, 0.8);
  return propertyOf(functions, unitDistance);
}

Dataset makeLattice(int size, const testing::Field& field)
{
  Dataset dataset;
  dataset.Array = "f";
  dataset.Grid = withOnly(testing::jitteredLattice(size, Jitter, Seed, field), dataset.Array);
  dataset.Range = { 0.0, 1.0, 0.25 };
  return dataset;
}

/// Two and a half waves an edge make the scalar turn several times along it.
Dataset makeWaves(int size)
{
  constexpr double waves = 2.5;
  Dataset dataset = makeLattice(size, testing::sineField(waves));
  dataset.Own = latticeProperty(dataset.Range.UnitDistance);
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
    { "front", makeFront }, { "refined", makeRefined } };
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

bool isDataset(const std::string& name)
{
  return filesByName().count(name) > 0 || partsByName().count(name) > 0 ||
         latticeOf(name).has_value();
}

bool isPresent(const std::string& name, const DataFolders& folders)
{
  const auto file = filesByName().find(name);
  return file == filesByName().end() || std::filesystem::exists(pathOf(file->second, folders));
}

Dataset makeDataset(const std::string& name, const DataFolders& folders)
{
  const auto lattice = latticeOf(name);
  const auto part = partsByName().find(name);
  if (part != partsByName().end())
  {
    return part->second(folders);
  }
  return lattice ? lattice->Make(lattice->Size) : read(name, filesByName().at(name), folders);
}
} // namespace tetmarch::bench
