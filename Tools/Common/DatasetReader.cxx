// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetReader.h"

#include "AdaptiveData.h"
#include "DataChecking.h"
#include "ErrorText.h"
#include "Failure.h"
#include "FileContents.h"
#include "GridMerging.h"
#include "Messages.h"

#include "vtkCellType.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkHyperTreeGrid.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkStructuredGrid.h"
#include "vtkTetMarchFirstPicture.h"

#include <algorithm>
#include <bitset>
#include <vector>

namespace
{
using tetmarch::Failure;

struct NamedBlock
{
  vtkDataSet* Data;
  const char* Name;       // may be null
  unsigned int FlatIndex; // in the tree
};

std::vector<NamedBlock> ListSolidBlocks(vtkDataObject* data)
{
  std::vector<NamedBlock> blocks;
  const auto add = [&blocks](vtkDataObject* block, const char* name, unsigned int flatIndex)
  {
    auto* dataSet = vtkDataSet::SafeDownCast(block);
    if (dataSet && !vtkPolyData::SafeDownCast(block) && tetmarch::HasSolidCells(dataSet))
    {
      blocks.push_back({ dataSet, name, flatIndex });
    }
  };
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto at = vtk::TakeSmartPointer(composite->NewIterator());
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    {
      add(at->GetCurrentDataObject(),
        at->HasCurrentMetaData() ? at->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME())
                                 : nullptr,
        at->GetCurrentFlatIndex());
    }
  }
  else
  {
    add(data, nullptr, 0);
  }
  return blocks;
}

std::string Describe(vtkDataObject* data)
{
  std::string text = data->GetClassName();
  if (tetmarch::IsStructured(data))
  {
    int n[3];
    tetmarch::GetDimensions(static_cast<vtkDataSet*>(data), n);
    text += " of " + std::to_string(n[0]) + " x " + std::to_string(n[1]) + " x " +
            std::to_string(n[2]) + " points";
  }
  return text;
}

std::vector<NamedBlock> GetSolidBlocks(vtkDataObject* data, const std::string& path)
{
  auto blocks = ListSolidBlocks(data);
  if (blocks.empty())
  {
    throw Failure(
      "'" + path + "' has no 3D cells, so there is no volume to render (" + Describe(data) + ")");
  }
  return blocks;
}

/// The blocks alone, without what else the file holds.
vtkSmartPointer<vtkDataObject> MakeTree(const std::vector<NamedBlock>& blocks)
{
  auto tree = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (const NamedBlock& block : blocks)
  {
    const unsigned int number = tree->GetNumberOfBlocks();
    tree->SetBlock(number, block.Data);
    if (block.Name)
    {
      tree->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), block.Name);
    }
  }
  return tree;
}

std::vector<vtkDataSet*> GetData(const std::vector<NamedBlock>& named)
{
  std::vector<vtkDataSet*> blocks;
  for (const NamedBlock& block : named)
  {
    blocks.push_back(block.Data);
  }
  return blocks;
}

/// Blocks are merged with the arrays that all of them have. If the wanted array is none of these,
/// or if there is none, those blocks are kept that have the array which vtkTetMarchFirstPicture
/// chooses of all, as mappers draw them.
std::vector<vtkDataSet*> GetMergeable(
  const std::vector<NamedBlock>& named, const tetmarch::WantedArray& wanted)
{
  const std::vector<vtkDataSet*> all = GetData(named);
  if (tetmarch::HaveCommonArray(all, wanted))
  {
    return all;
  }
  vtkNew<vtkTetMarchFirstPicture> choice;
  const tetmarch::ErrorText error(choice);
  choice->SetInputData(MakeTree(named));
  choice->SetArrayName(wanted.Name);
  choice->SetArrayAssociation(wanted.Association);
  if (!choice->ChooseArray())
  {
    return all; // it is said later that they have no such array
  }
  vtkDataArray* array = choice->GetChosenArray();
  const int association = choice->GetChosenAssociation();
  std::vector<vtkDataSet*> blocks;
  std::string others;
  for (const NamedBlock& block : named)
  {
    vtkDataArray* own =
      block.Data->GetAttributesAsFieldData(association)->GetArray(array->GetName());
    if (own && own->GetNumberOfComponents() == array->GetNumberOfComponents())
    {
      blocks.push_back(block.Data);
    }
    else
    {
      others +=
        (others.empty() ? "" : ", ") + (block.Name ? '"' + std::string(block.Name) + '"'
                                                   : "number " + std::to_string(block.FlatIndex));
    }
  }
  if (!others.empty())
  {
    tetmarch::PrintMessage(
      "warning", std::string("blocks without ") +
                   (association == vtkTetMarchFirstPicture::CELLS ? "cell" : "point") + " array '" +
                   array->GetName() + "' are not drawn: " + others);
  }
  return blocks;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(const std::vector<NamedBlock>& named, bool ofPieces,
  const tetmarch::WantedArray& wanted, const tetmarch::ProgressReport& report)
{
  const std::vector<vtkDataSet*> blocks = GetMergeable(named, wanted);
  for (vtkDataSet* block : blocks)
  {
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(block))
    {
      grid->RemoveGhostCells(); // vtkAppendFilter merges no points where there are ghosts
    }
  }
  tetmarch::WarnOfPartialArrays(blocks);
  vtkSmartPointer<vtkUnstructuredGrid> grid = vtkUnstructuredGrid::SafeDownCast(blocks[0]);
  if (blocks.size() > 1 || !grid || ofPieces)
  {
    grid = tetmarch::MergeBlocks(blocks, report);
  }
  return grid;
}
} // namespace

namespace tetmarch
{

bool HasSolidCells(vtkDataSet* data)
{
  if (IsStructured(data)) // of a billion cells, maybe
  {
    int n[3];
    GetDimensions(data, n);
    return std::min({ n[0], n[1], n[2] }) > 1;
  }
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
  const std::string& path, std::optional<int> timeStep, const WantedArray& wanted)
{
  const FileContents contents = ReadFile(path, timeStep, {}, {});
  CheckData(contents.Data, path);
  return MakeGrid(GetSolidBlocks(contents.Data, path), contents.OfPieces, wanted, {});
}

VolumeData ReadVolume(const std::string& path, std::optional<int> timeStep,
  const RawOptions& rawOptions, const WantedArray& wanted, const ProgressReport& report)
{
  const FileContents contents = ReadFile(path, timeStep, rawOptions, report);
  VolumeData volume;
  volume.Adaptive = IsAdaptive(contents.Data);
  if (!wanted.Continuous)
  {
    volume.HyperTree = vtkHyperTreeGrid::SafeDownCast(contents.Data);
  }
  const auto data = ConvertAdaptive(contents.Data, wanted.Continuous);
  CheckData(data, path);
  const auto blocks = GetSolidBlocks(data, path);
  volume.Times = contents.Times;
  volume.TimeStep =
    timeStep.value_or(std::max<int>(static_cast<int>(contents.Times.size()) - 1, 0));
  if (IsAdaptive(data))
  {
    volume.Input = data;
    volume.Blocks = GetData(blocks);
    return volume;
  }
  volume.Structured = std::all_of(
    blocks.begin(), blocks.end(), [](const NamedBlock& block) { return IsStructured(block.Data); });
  if (volume.Structured && blocks.size() > 1)
  {
    volume.Input = MakeTree(blocks);
    volume.Blocks = GetData(blocks);
    return volume;
  }
  vtkSmartPointer<vtkDataSet> whole = blocks[0].Data;
  const bool isCurvilinear =
    blocks.size() == 1 && !contents.OfPieces && vtkStructuredGrid::SafeDownCast(whole);
  if (!volume.Structured && !isCurvilinear)
  {
    whole = MakeGrid(blocks, contents.OfPieces, wanted, report);
  }
  volume.Input = whole;
  volume.Blocks = { whole };
  return volume;
}

std::vector<std::string> ListFaults(
  const std::string& path, std::optional<int> timeStep, const RawOptions& rawOptions)
{
  const auto data = ConvertAdaptive(ReadFile(path, timeStep, rawOptions, {}).Data, false);
  std::vector<std::string> faults = ListFaults(data);
  if (faults.empty())
  {
    GetSolidBlocks(data, path);
  }
  return faults;
}

vtkSmartPointer<vtkPolyData> ReadSurface(const std::string& path, const ProgressReport& report)
{
  const vtkSmartPointer<vtkDataObject> data = ReadFile(path, std::nullopt, {}, report).Data;
  vtkSmartPointer<vtkPolyData> surface = vtkPolyData::SafeDownCast(data);
  if (!surface || surface->GetNumberOfPolys() + surface->GetNumberOfStrips() == 0)
  {
    throw Failure("'" + path + "' has no polygons, so there is no surface to draw (" +
                  data->GetClassName() + ")");
  }
  return surface;
}

} // namespace tetmarch
