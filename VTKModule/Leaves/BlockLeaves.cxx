// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The leaves of adaptive meshes of blocks.
#include "Leaves/LeafList.h"

#include "Blocks/BlockList.h"
#include "Blocks/RefinedCells.h"
#include "Input/DataCheck.h"
#include "Input/SolidCells.h"
#include "Scalars/GhostArrays.h"

#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkUniformGridAMR.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetmarch
{
namespace
{

// The lattice of the smallest cells of all blocks, along an axis.
struct BlockLattice
{
  double Low = std::numeric_limits<double>::max();
  double High = std::numeric_limits<double>::lowest();
  double Width = std::numeric_limits<double>::max();

  void include(vtkImageData* block, int axis)
  {
    this->Low = std::min(this->Low, block->GetBounds()[2 * axis]);
    this->High = std::max(this->High, block->GetBounds()[2 * axis + 1]);
    this->Width = std::min(this->Width, block->GetSpacing()[axis]);
  }
  double cells(double length) const { return length / this->Width; }
  LeafAxis axis() const
  {
    const int cells = static_cast<int>(std::lround(this->cells(this->High - this->Low)));
    return { { this->Low, this->High }, cells };
  }
};

bool isWhole(double cells) { return std::abs(cells - std::round(cells)) < 1e-3; }

std::string findLattices(const std::vector<Block>& blocks, std::array<BlockLattice, 3>& lattices)
{
  for (const Block& block : blocks)
  {
    for (int a = 0; a < 3; ++a)
    {
      lattices[a].include(vtkImageData::SafeDownCast(block.Data), a);
    }
  }
  for (const Block& block : blocks)
  {
    auto* image = vtkImageData::SafeDownCast(block.Data);
    for (int a = 0; a < 3; ++a)
    {
      const BlockLattice& lattice = lattices[a];
      if (!(lattice.cells(lattice.High - lattice.Low) < MostLeafPlaces))
      {
        return "The blocks are " + std::to_string(lattice.cells(lattice.High - lattice.Low)) +
               " of their smallest cells wide, more than 2^30: leave the finest levels out.";
      }
      if (!isWhole(lattice.cells(image->GetBounds()[2 * a] - lattice.Low)) ||
          !isWhole(lattice.cells(image->GetSpacing()[a])))
      {
        return "Block " + block.Name +
               " lies between the smallest cells of the mesh, whose widths "
               "and places must be whole multiples of these.";
      }
    }
  }
  return {};
}

// The arrays of cells that all blocks have; one list for each block.
std::vector<std::vector<vtkDataArray*>> commonArrays(const std::vector<Block>& blocks)
{
  std::vector<std::vector<vtkDataArray*>> arrays(blocks.size());
  for (vtkDataArray* array : valueArraysOf(blocks.front().Data->GetCellData()))
  {
    const auto fits = [&](const Block& block)
    {
      vtkDataArray* other = block.Data->GetCellData()->GetArray(array->GetName());
      return other && other->GetNumberOfComponents() == array->GetNumberOfComponents() &&
             other->GetNumberOfTuples() == block.Data->GetNumberOfCells();
    };
    if (std::all_of(blocks.begin(), blocks.end(), fits))
    {
      for (std::size_t b = 0; b < blocks.size(); ++b)
      {
        arrays[b].push_back(blocks[b].Data->GetCellData()->GetArray(array->GetName()));
      }
    }
  }
  return arrays;
}

void addCells(const Block& block, int number, const std::vector<bool>& refined,
  const std::array<BlockLattice, 3>& lattices, LeafList& list)
{
  auto* image = vtkImageData::SafeDownCast(block.Data);
  vtkUnsignedCharArray* ghosts = ghostArraysOf(image).OfCells;
  int points[3];
  image->GetDimensions(points);
  Leaf leaf;
  LeafPlace begin{};
  for (int a = 0; a < 3; ++a)
  {
    const BlockLattice& lattice = lattices[a];
    begin[a] =
      static_cast<int>(std::lround(lattice.cells(image->GetBounds()[2 * a] - lattice.Low)));
    leaf.Size[a] = static_cast<int>(std::lround(lattice.cells(image->GetSpacing()[a])));
  }
  const vtkIdType row = points[0] - 1;
  const vtkIdType layer = row * (points[1] - 1);
  for (vtkIdType c = 0; c < image->GetNumberOfCells(); ++c)
  {
    const int ghost = ghosts ? ghosts->GetValue(c) : 0;
    const bool elsewhere =
      (!refined.empty() && refined[c]) ||
      (ghost & (vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::REFINEDCELL)) != 0;
    if (!elsewhere)
    {
      const std::array<vtkIdType, 3> at{ { c % row, c % layer / row, c / layer } };
      for (int a = 0; a < 3; ++a)
      {
        leaf.Low[a] = begin[a] + static_cast<int>(at[a]) * leaf.Size[a];
      }
      list.add(leaf, image->IsCellVisible(c) != 0, number, c);
    }
  }
}

} // namespace

bool hasLeaves(const Block& block)
{
  return vtkImageData::SafeDownCast(block.Data) && hasSolidCells(block.Data);
}

std::string listLeaves(
  vtkUniformGridAMR* data, const std::vector<Block>& blocks, LeafList& list, LeafAxes& axes)
{
  std::array<BlockLattice, 3> lattices;
  std::string error = findLattices(blocks, lattices);
  if (error.empty())
  {
    const std::vector<std::vector<bool>> refined = refinedCells(data, blocks);
    for (std::size_t b = 0; b < blocks.size(); ++b)
    {
      addCells(blocks[b], static_cast<int>(b), refined.empty() ? std::vector<bool>() : refined[b],
        lattices, list);
    }
    axes = { { lattices[0].axis(), lattices[1].axis(), lattices[2].axis() } };
  }
  return error;
}

std::string findLeaves(vtkUniformGridAMR* blocks, Leaves& leaves)
{
  std::vector<Block> drawn = listBlocks(blocks, {});
  drawn.erase(
    std::remove_if(drawn.begin(), drawn.end(), [](const Block& b) { return !hasLeaves(b); }),
    drawn.end());
  if (drawn.empty())
  {
    return "The adaptive mesh has no block with cells in three dimensions.";
  }
  for (const Block& block : drawn)
  {
    std::string error = checkData(block.Data);
    error = error.empty() ? checkGhosts(block.Data) : error;
    if (!error.empty())
    {
      return "Block " + block.Name + ": " + error;
    }
  }
  LeafList list;
  LeafAxes axes;
  std::string error = listLeaves(blocks, drawn, list, axes);
  if (error.empty())
  {
    leaves = list.made(std::move(axes), commonArrays(drawn));
    leaves.ActiveScalars = activeScalarsOf(drawn.front().Data->GetCellData());
  }
  return error;
}

} // namespace tetmarch
