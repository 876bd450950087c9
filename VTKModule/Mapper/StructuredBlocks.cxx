// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/StructuredBlocks.h"

#include "Blocks/BlockList.h"
#include "Blocks/BlockOrder.h"

#include "vtkCamera.h"
#include "vtkCompositeDataSet.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRectilinearGrid.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <iterator>

namespace tetmarch
{
namespace
{

bool isStructured(vtkDataObject* data)
{
  return vtkImageData::SafeDownCast(data) || vtkRectilinearGrid::SafeDownCast(data);
}

std::string describeOther(vtkDataObject* data)
{
  return std::string("a ") + data->GetClassName() +
         ", but only images (vtkImageData, vtkUniformGrid) and rectilinear grids "
         "(vtkRectilinearGrid) can be drawn. vtkTetMarchVolumeMapper draws unstructured grids, and "
         "trees of blocks of any kind.";
}

// Blocks that are left out; empty if there are none.
std::string describeOthers(
  std::vector<Block>::const_iterator first, std::vector<Block>::const_iterator last)
{
  const auto count = std::distance(first, last);
  return count == 0
           ? std::string()
           : std::to_string(count) + (count == 1 ? " block is" : " blocks are") +
               " not drawn, since only images and rectilinear grids are: " +
               (count == 1 ? "" : "the first is ") + "block " + first->Name + ", a " +
               first->Data->GetClassName() +
               ". A vtkTetMarchVolumeMapper draws such blocks, and trees of blocks of any kind.";
}

// The eye in the coordinates of the volume's data: (point, 1) or (direction towards it, 0).
std::array<double, 4> eyeOf(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  std::array<double, 4> eye{ { 0, 0, 0, 1 } };
  if (camera->GetParallelProjection())
  {
    camera->GetViewPlaneNormal(eye.data());
    eye[3] = 0;
  }
  else
  {
    camera->GetPosition(eye.data());
  }
  vtkNew<vtkMatrix4x4> toData;
  vtkMatrix4x4::Invert(volume->GetMatrix(), toData);
  toData->MultiplyPoint(eye.data(), eye.data());
  return eye;
}

} // namespace

// Of a tree the blocks with the array; else the data as the only block.
std::string StructuredBlocks::find(
  vtkDataObject* input, const ScalarSelection& selection, std::vector<Block>& found)
{
  auto* tree = vtkCompositeDataSet::SafeDownCast(input);
  this->OfTree = tree != nullptr;
  if (!tree && !isStructured(input))
  {
    return "The input is " + describeOther(input);
  }
  if (!tree)
  {
    auto* data = static_cast<vtkDataSet*>(input);
    const FoundScalars scalars = findScalars(data, selection);
    found.push_back({ data, 1, {}, scalars.Array, scalars.OfCells });
  }
  else
  {
    found = listBlocks(tree, selection);
  }
  found.erase(std::remove_if(found.begin(), found.end(),
                [](const Block& block) { return block.Data->GetNumberOfCells() == 0; }),
    found.end());
  const auto others = std::stable_partition(
    found.begin(), found.end(), [](const Block& block) { return isStructured(block.Data); });
  if (others == found.begin() && others != found.end())
  {
    return "Block " + others->Name + " is " + describeOther(others->Data) +
           " No other block is one of these.";
  }
  this->Omissions = describeOthers(others, found.end());
  found.erase(others, found.end());
  return {};
}

std::string StructuredBlocks::update(vtkDataObject* input, const ScalarSelection& selection)
{
  this->Omissions.clear();
  std::vector<Block> found;
  std::string error = this->find(input, selection, found);
  if (!error.empty())
  {
    this->keep(0);
    return error;
  }
  std::vector<Block> drawn;
  std::copy_if(found.begin(), found.end(), std::back_inserter(drawn),
    [](const Block& block) { return block.Scalars != nullptr; });
  if (drawn.empty() && !found.empty())
  {
    this->keep(0);
    return describeMissingScalars(
      found.front().Data, selection, this->OfTree ? "No block has " : "The input has no ");
  }
  std::string bare;
  for (const Block& block : found)
  {
    bare += block.Scalars ? "" : (bare.empty() ? "" : ", ") + block.Name;
  }
  if (!bare.empty())
  {
    this->Omissions += (this->Omissions.empty() ? "" : " ") + std::string("Blocks without ") +
                       describe(selection) + " are not drawn: " + bare + ".";
  }
  this->keep(drawn.size());
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    StructuredBlock& block = *this->Blocks[i];
    block.Data = drawn[i].Data;
    block.Scalars = { drawn[i].Scalars, drawn[i].CellScalars };
    block.Origins = {};
    block.Origins.add(drawn[i].FlatIndex, drawn[i].Data->GetNumberOfCells());
  }
  return {};
}

void StructuredBlocks::keep(std::size_t count)
{
  while (this->Blocks.size() > count)
  {
    this->Blocks.back()->Pipeline.releaseWhereHeld();
    this->Blocks.pop_back();
  }
  while (this->Blocks.size() < count)
  {
    this->Blocks.push_back(std::make_unique<StructuredBlock>());
  }
}

void StructuredBlocks::releaseIfHeldBy(vtkWindow* window)
{
  for (const auto& block : this->Blocks)
  {
    block->Pipeline.releaseIfHeldBy(window);
  }
}

std::vector<StructuredBlock*> StructuredBlocks::backToFront(
  vtkRenderer* renderer, vtkVolume* volume) const
{
  std::vector<BlockBox> boxes;
  for (const auto& block : this->Blocks)
  {
    BlockBox box{};
    block->Data->GetBounds(box.data());
    boxes.push_back(box);
  }
  std::vector<StructuredBlock*> order;
  for (std::size_t i : tetmarch::backToFront(boxes, eyeOf(renderer, volume)))
  {
    order.push_back(this->Blocks[i].get());
  }
  return order;
}

} // namespace tetmarch
