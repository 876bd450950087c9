// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Datasets.h"

#include "DatasetReader.h"
#include "Failure.h"
#include "KeptCells.h"
#include "Lattices.h"
#include "SolidParts.h"
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
} // namespace

bool isDataset(const std::string& name)
{
  return filesByName().count(name) > 0 || partsByName().count(name) > 0 || isSolidPart(name) ||
         isLattice(name);
}

bool isPresent(const std::string& name, const DataFolders& folders)
{
  if (isSolidPart(name))
  {
    return std::filesystem::exists(pathOfSolidPart(name, folders));
  }
  const auto file = filesByName().find(name);
  return file == filesByName().end() || file->second.Folder == &DataFolders::Own ||
         std::filesystem::exists(pathOf(file->second, folders));
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

Dataset makeDataset(const std::string& name, const DataFolders& folders)
{
  const auto part = partsByName().find(name);
  if (part != partsByName().end())
  {
    return part->second(folders);
  }
  if (isSolidPart(name))
  {
    return readSolidPart(name, folders);
  }
  return isLattice(name) ? makeLattice(name) : read(name, filesByName().at(name), folders);
}
} // namespace tetmarch::bench
