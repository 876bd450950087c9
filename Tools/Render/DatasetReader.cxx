// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetReader.h"

#include "Failure.h"
#include "FileReader.h"
#include "Messages.h"
#include "ProgressBar.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkGenericCell.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <bitset>
#include <filesystem>
#include <map>
#include <vector>

namespace
{
using tetmarch::Failure;

void CheckFile(const std::string& path)
{
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  if (!std::filesystem::exists(status))
  {
    throw Failure("cannot read '" + path + "': there is no such file");
  }
  if (std::filesystem::is_directory(status))
  {
    throw Failure("cannot read '" + path + "': it is a folder");
  }
}

/// Reads the chosen time step, by default the last.
void Update(vtkAlgorithm* reader, std::optional<int> timeStep)
{
  reader->UpdateInformation();
  vtkInformation* information = reader->GetOutputInformation(0);
  auto* key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  const int count = information->Has(key) ? information->Length(key) : 0;
  if (timeStep && *timeStep >= count)
  {
    throw Failure(
      "time step " + std::to_string(*timeStep) + " does not exist: the file has " +
      (count == 0 ? "no time steps"
                  : std::to_string(count) + ", counted from 0 to " + std::to_string(count - 1)));
  }
  if (count > 0)
  {
    reader->UpdateTimeStep(information->Get(key)[timeStep.value_or(count - 1)]);
  }
  else
  {
    reader->Update();
  }
}

vtkSmartPointer<vtkDataObject> Read(const std::string& path, std::optional<int> timeStep)
{
  CheckFile(path);
  const int errorsBefore = tetmarch::Messages::GetNumberOfErrors();
  vtkSmartPointer<vtkAlgorithm> reader = tetmarch::MakeReader(path);
  {
    tetmarch::ProgressBar progress("reading", reader);
    Update(reader, timeStep);
  }
  vtkDataObject* data = reader->GetOutputDataObject(0);
  if (tetmarch::Messages::GetNumberOfErrors() > errorsBefore || !data ||
      reader->GetErrorCode() != 0)
  {
    throw Failure("cannot read '" + path +
                  "': the file is damaged or not of the kind that its ending "
                  "says");
  }
  return data;
}

std::vector<vtkDataSet*> ListSolidBlocks(vtkDataObject* data)
{
  std::vector<vtkDataSet*> blocks;
  const auto add = [&blocks](vtkDataObject* block)
  {
    auto* dataSet = vtkDataSet::SafeDownCast(block);
    if (dataSet && !vtkPolyData::SafeDownCast(block) && tetmarch::HasSolidCells(dataSet))
    {
      blocks.push_back(dataSet);
    }
  };
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto iterator = vtk::TakeSmartPointer(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      add(iterator->GetCurrentDataObject());
    }
  }
  else
  {
    add(data);
  }
  return blocks;
}

/// vtkAppendFilter keeps the arrays that all blocks have.
void WarnOfPartialArrays(const std::vector<vtkDataSet*>& blocks)
{
  for (const bool cells : { false, true })
  {
    std::map<std::string, std::size_t> counts;
    for (vtkDataSet* block : blocks)
    {
      vtkDataSetAttributes* arrays =
        cells ? static_cast<vtkDataSetAttributes*>(block->GetCellData()) : block->GetPointData();
      for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
      {
        const char* name = arrays->GetArrayName(i);
        ++counts[name ? name : ""];
      }
    }
    for (const auto& [name, count] : counts)
    {
      if (count < blocks.size())
      {
        tetmarch::PrintMessage("warning",
          std::string(cells ? "cell" : "point") + " array '" + name + "' is left out: only " +
            std::to_string(count) + " of " + std::to_string(blocks.size()) + " blocks have it");
      }
    }
  }
}

/// The first point of a grid with its arrays and no cell.
vtkSmartPointer<vtkUnstructuredGrid> MakeFirstPoint(vtkUnstructuredGrid* grid)
{
  auto first = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(grid->GetPoints()->GetDataType());
  points->InsertNextPoint(grid->GetPoint(0));
  first->SetPoints(points);
  first->GetPointData()->CopyAllOn();
  first->GetPointData()->CopyAllocate(grid->GetPointData(), 1);
  first->GetPointData()->CopyData(grid->GetPointData(), vtkIdType(0), vtkIdType(0));
  first->GetCellData()->CopyAllOn();
  first->GetCellData()->CopyAllocate(grid->GetCellData(), 0);
  return first;
}

vtkSmartPointer<vtkUnstructuredGrid> Merge(const std::vector<vtkDataSet*>& blocks)
{
  auto append = vtkSmartPointer<vtkAppendFilter>::New();
  append->MergePointsOn();
  for (vtkDataSet* block : blocks)
  {
    append->AddInputData(block);
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(blocks[0]);
  if (grid && blocks.size() == 1)
  {
    append->AddInputData(MakeFirstPoint(grid)); // one input alone would be passed through
  }
  tetmarch::ProgressBar progress("merging", append);
  append->Update();
  return append->GetOutput();
}

/// Pieces of a parallel file repeat the points between them and their neighbours' cells.
bool HasPieces(const std::string& path)
{
  const std::string ending = std::filesystem::path(path).extension().string();
  return ending.size() > 1 && (ending[1] == 'p' || ending[1] == 'P');
}
} // namespace

namespace tetmarch
{

bool HasSolidCells(vtkDataSet* data)
{
  std::bitset<256> types;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    types.set(static_cast<unsigned char>(data->GetCellType(i)));
  }
  auto cell = vtkSmartPointer<vtkGenericCell>::New();
  for (int type = 0; type < 256; ++type)
  {
    cell->SetCellType(types[type] ? type : VTK_EMPTY_CELL);
    if (cell->GetCellDimension() == 3)
    {
      return true;
    }
  }
  return false;
}

vtkSmartPointer<vtkUnstructuredGrid> ReadUnstructuredGrid(
  const std::string& path, std::optional<int> timeStep)
{
  const vtkSmartPointer<vtkDataObject> data = Read(path, timeStep);
  const auto blocks = ListSolidBlocks(data);
  if (blocks.empty())
  {
    throw Failure("'" + path + "' has no 3D cells, so there is no volume to render (" +
                  data->GetClassName() + ")");
  }
  for (vtkDataSet* block : blocks) // vtkAppendFilter merges no points where there are ghosts
  {
    if (auto* blockGrid = vtkUnstructuredGrid::SafeDownCast(block))
    {
      blockGrid->RemoveGhostCells();
    }
  }
  WarnOfPartialArrays(blocks);
  vtkSmartPointer<vtkUnstructuredGrid> grid = vtkUnstructuredGrid::SafeDownCast(blocks[0]);
  if (blocks.size() > 1 || !grid || HasPieces(path))
  {
    grid = Merge(blocks);
  }
  return grid;
}

vtkSmartPointer<vtkPolyData> ReadSurface(const std::string& path)
{
  const vtkSmartPointer<vtkDataObject> data = Read(path, std::nullopt);
  vtkSmartPointer<vtkPolyData> surface = vtkPolyData::SafeDownCast(data);
  if (!surface || surface->GetNumberOfPolys() + surface->GetNumberOfStrips() == 0)
  {
    throw Failure("'" + path + "' has no polygons, so there is no surface to draw (" +
                  data->GetClassName() + ")");
  }
  return surface;
}

} // namespace tetmarch
