// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/DataCheck.h"

#include "Input/GridCheck.h"
#include "Input/GridContent.h"
#include "Input/GridGeometry.h"
#include "Input/PointCheck.h"

#include "vtkCellData.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <deque>
#include <mutex>
#include <utility>

namespace tetmarch
{
namespace
{

// Results of previous grids, each with the versions of its input.
class Verdicts
{
public:
  template <typename Find>
  std::string of(const Fingerprint& version, const Find& find)
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      const auto known = std::find_if(this->Known.begin(), this->Known.end(),
        [&version](const auto& verdict) { return verdict.first == version; });
      if (known != this->Known.end())
      {
        return known->second;
      }
    }
    std::string found = find();
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Known.emplace_front(version, found);
    this->Known.resize(std::min(this->Known.size(), Most));
    return found;
  }

private:
  static constexpr std::size_t Most = 64; // enough for the blocks of most data sets

  std::mutex Mutex;
  std::deque<std::pair<Fingerprint, std::string>> Known;
};

std::string checkUnstructured(vtkUnstructuredGrid* grid)
{
  static Verdicts verdicts;
  Fingerprint version = versionOf(grid);
  add(
    version, grid); // code that changes the values of an array may call only Modified() of the grid
  return verdicts.of(version, [grid] { return checkGrid(grid); });
}

std::string checkLattice(vtkDataSet* data)
{
  GridGeometry geometry;
  VolumeFrame frame;
  const std::string wrong = readGeometry(data, geometry);
  return wrong.empty() && !geometry.isEmpty() ? findFrame(geometry, frame) : wrong;
}

// For grids whose dimensions determine the number of points.
std::string checkDimensions(vtkPointSet* grid, const int n[3])
{
  const vtkIdType expected = vtkIdType(n[0]) * n[1] * n[2];
  if (grid->GetNumberOfPoints() < expected)
  {
    return "The structured grid has " + std::to_string(grid->GetNumberOfPoints()) +
           " points, but its dimensions " + std::to_string(n[0]) + " x " + std::to_string(n[1]) +
           " x " + std::to_string(n[2]) + " call for " + std::to_string(expected) +
           ". Set as many points as its dimensions say.";
  }
  const int components = grid->GetPoints()->GetData()->GetNumberOfComponents();
  return components == 3
           ? std::string()
           : "The points have " + std::to_string(components) + " components instead of 3.";
}

// A cell of a point; both are numbered along x first.
vtkIdType cellOf(vtkIdType point, const int n[3])
{
  vtkIdType cell = 0;
  vtkIdType stride = 1;
  for (int a = 0; a < 3; ++a)
  {
    const vtkIdType cells = std::max(n[a] - 1, 1);
    cell += stride * std::min(point % n[a], cells - 1);
    point /= n[a];
    stride *= cells;
  }
  return cell;
}

std::string checkCurvilinear(vtkStructuredGrid* grid)
{
  int n[3];
  grid->GetDimensions(n);
  const std::string wrong = checkDimensions(grid, n);
  if (!wrong.empty())
  {
    return wrong;
  }
  const std::vector<char> sound = findSoundPoints(grid->GetPoints());
  const auto unsound = std::find(sound.begin(), sound.end(), 0);
  const vtkIdType point = unsound - sound.begin();
  const bool ofCell = unsound != sound.end() && point < vtkIdType(n[0]) * n[1] * n[2];
  return ofCell ? describeUnsoundPoint(grid->GetPoints(), point, cellOf(point, n)) : std::string();
}

std::string checkExplicit(vtkExplicitStructuredGrid* grid)
{
  const vtkIdType points = grid->GetNumberOfPoints();
  const std::string wrong = checkHexahedra(grid->GetCells(), grid->GetNumberOfCells(), points);
  const std::vector<char> sound =
    wrong.empty() && points > 0 ? findSoundPoints(grid->GetPoints()) : std::vector<char>();
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; !sound.empty() && cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    const vtkIdType* unsound =
      std::find_if(ids->begin(), ids->end(), [&sound](vtkIdType id) { return !sound[id]; });
    if (unsound != ids->end())
    {
      return describeUnsoundPoint(grid->GetPoints(), *unsound, cell);
    }
  }
  return wrong;
}

// VTK ignores ghost arrays of other types.
std::string checkGhosts(vtkDataSet* data, bool ofCells)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  vtkDataSetAttributes* attributes =
    ofCells ? static_cast<vtkDataSetAttributes*>(data->GetCellData()) : data->GetPointData();
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(attributes->GetArray(name));
  const vtkIdType count = ofCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  if (!ghosts || (ghosts->GetNumberOfComponents() == 1 && ghosts->GetNumberOfTuples() == count))
  {
    return {};
  }
  return std::string("The array \"") + name + "\" has " +
         std::to_string(ghosts->GetNumberOfTuples()) + " tuples of " +
         std::to_string(ghosts->GetNumberOfComponents()) + " component(s), but the grid has " +
         std::to_string(count) + (ofCells ? " cells" : " points") +
         ". Give it one value for each, or remove it.";
}

} // namespace

std::string checkGhosts(vtkDataSet* data)
{
  const std::string error = checkGhosts(data, true);
  return error.empty() ? checkGhosts(data, false) : error;
}

std::string checkData(vtkDataSet* data)
{
  if (!data || data->GetNumberOfCells() == 0)
  {
    return {};
  }
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return checkUnstructured(grid);
  }
  if (vtkImageData::SafeDownCast(data) || vtkRectilinearGrid::SafeDownCast(data))
  {
    return checkLattice(data);
  }
  std::string error;
  if (auto* curvilinear = vtkStructuredGrid::SafeDownCast(data))
  {
    error = checkCurvilinear(curvilinear);
  }
  else if (auto* listed = vtkExplicitStructuredGrid::SafeDownCast(data))
  {
    error = checkExplicit(listed);
  }
  return error.empty() ? checkGhosts(data) : error;
}

} // namespace tetmarch
