// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SolidParts.h"

#include "DatasetReader.h"
#include "Fields.h"
#include "FinerTetrahedra.h"

#include "vtkBoundingBox.h"

#include <map>

namespace tetmarch::bench
{
namespace
{
// As shares of the longest edge. The parts are some 0.075 thick where a ray goes through all walls.
constexpr double UnitDistance = 0.02;
constexpr double Wave = 0.1;

const std::map<std::string, std::string>& pathsByName()
{
  static const std::map<std::string, std::string> paths = {
    { "wheelset", "unstructured/wheelset.vtk" }, { "crushed-can", "unstructured/can.vtu" }
  };
  return paths;
}

testing::Field wavesIn(const vtkBoundingBox& box)
{
  return [box, field = testing::sineField(1.0 / Wave)](double x, double y, double z)
  {
    const double* low = box.GetMinPoint();
    const double edge = box.GetMaxLength();
    return field((x - low[0]) / edge, (y - low[1]) / edge, (z - low[2]) / edge);
  };
}
} // namespace

bool isSolidPart(const std::string& name) { return pathsByName().count(name) > 0; }

std::string pathOfSolidPart(const std::string& name, const DataFolders& folders)
{
  return folders.Others + "/" + pathsByName().at(name);
}

Dataset readSolidPart(const std::string& name, const DataFolders& folders)
{
  Dataset dataset;
  dataset.Array = "f";
  const auto grid =
    finerTetrahedra(ReadUnstructuredGrid(pathOfSolidPart(name, folders), std::nullopt));
  const vtkBoundingBox box(grid->GetBounds());
  testing::attachFields(grid, wavesIn(box));
  dataset.Grid = withOnly(grid, dataset.Array);
  dataset.Range = { 0.0, 1.0, UnitDistance * box.GetMaxLength() };
  dataset.Own = wavesProperty(dataset.Range.UnitDistance);
  return dataset;
}
} // namespace tetmarch::bench
