// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/JoinedBlocks.h"

#include "Blocks/RefinedCells.h"
#include "Caching/WithinMemory.h"
#include "Input/DataCheck.h"
#include "Input/HigherOrderCheck.h"
#include "Input/SolidCells.h"
#include "Input/TreeCheck.h"
#include "Scalars/DrawnScalars.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkHyperTreeGrid.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGridBase.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

// Whether the block's array can be joined with that of the first block.
bool fits(const Block& block, const Block& first)
{
  return block.Scalars && block.CellScalars == first.CellScalars &&
         block.Scalars->GetNumberOfComponents() == first.Scalars->GetNumberOfComponents();
}

// The only block, if it is a grid that can be drawn unchanged; else null.
vtkUnstructuredGrid* onlyGridOf(const std::vector<Block>& drawn)
{
  return drawn.size() == 1 ? vtkUnstructuredGrid::SafeDownCast(drawn.front().Data) : nullptr;
}

void addName(std::string& names, const std::string& name)
{
  names += (names.empty() ? "" : ", ") + name;
}

// Before a message.
std::string of(const Block& block)
{
  return block.Name.empty() ? std::string() : "Block " + block.Name + ": ";
}

std::string checkBlock(const Block& block)
{
  std::string error = checkData(block.Data);
  const bool computesCells = !vtkUnstructuredGrid::SafeDownCast(block.Data);
  error = error.empty() && computesCells ? checkGhosts(block.Data) : error;
  if (error.empty() && computesCells && vtkUnstructuredGridBase::SafeDownCast(block.Data))
  {
    error =
      std::string("It is a ") + block.Data->GetClassName() +
      ", which can't be joined with others. vtkAppendFilter makes a vtkUnstructuredGrid of it.";
  }
  return error.empty() ? error : of(block) + error;
}

} // namespace

void JoinedBlocks::clear()
{
  const StageRecord record = this->Record;
  *this = {};
  this->Record = record;
}

void JoinedBlocks::restart()
{
  MadeGrids made = std::move(this->Made);
  this->clear();
  this->Made = std::move(made);
}

// Choose the blocks that are drawn.
std::string JoinedBlocks::choose(const std::vector<Block>& blocks, const ScalarSelection& selection)
{
  std::string lacking;
  const Block* first = nullptr;
  const Block* firstSolid = nullptr;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    if (!hasSolidCells(blocks[b].Data))
    {
      continue;
    }
    firstSolid = firstSolid ? firstSolid : &blocks[b];
    first = !first && blocks[b].Scalars ? &blocks[b] : first;
    if (first && fits(blocks[b], *first))
    {
      this->Drawn.push_back(b);
    }
    else
    {
      addName(lacking, blocks[b].Name);
    }
  }
  if (!first)
  {
    return firstSolid ? firstSolid->Name.empty()
                          ? describeMissingScalars(firstSolid->Data, selection)
                          : describeMissingScalars(firstSolid->Data, selection, "No block has ")
                      : std::string();
  }
  this->CellScalars = first->CellScalars;
  if (!lacking.empty())
  {
    this->Omissions = "Blocks without " + describe(selection) + " are not drawn: " + lacking +
                      ". Others have it for their " + (first->CellScalars ? "cells" : "points") +
                      ", with " + std::to_string(first->Scalars->GetNumberOfComponents()) +
                      " component(s).";
  }
  return {};
}

std::vector<Block> JoinedBlocks::drawnOf(const std::vector<Block>& blocks)
{
  std::vector<Block> drawn;
  this->Shared.Data.clear();
  for (std::size_t b : this->Drawn)
  {
    drawn.push_back(blocks[b]);
    this->Shared.Data.push_back(blocks[b].Data);
  }
  return drawn;
}

std::string JoinedBlocks::join(const std::vector<Block>& drawn)
{
  for (const Block& block : drawn)
  {
    std::string error = checkBlock(block);
    if (!error.empty())
    {
      return error;
    }
    this->Origins.add(block.FlatIndex, block.Data->GetNumberOfCells());
  }
  if (!onlyGridOf(drawn) && !drawn.empty())
  {
    this->Shared.Points = sharePoints(this->Shared.Data, this->Shared.Count);
    this->joinGrid();
  }
  return {};
}

void JoinedBlocks::joinGrid()
{
  this->Grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  this->Grid->SetPoints(joinPoints(this->Shared));
  joinCells(this->Shared, this->Grid);
  this->joinAttributes();
}

// Join the arrays that affect the mesh.
void JoinedBlocks::joinAttributes()
{
  this->Grid->GetPointData()->AddArray(joinPointGhosts(this->Shared));
  this->Grid->GetCellData()->AddArray(joinCellGhosts(this->Shared));
  std::vector<vtkDataArray*> degrees;
  std::vector<vtkDataArray*> weights;
  for (vtkDataSet* block : this->Shared.Data)
  {
    degrees.push_back(block->GetCellData()->GetHigherOrderDegrees());
    weights.push_back(block->GetPointData()->GetRationalWeights());
  }
  const auto all = [](const std::vector<vtkDataArray*>& arrays)
  { return std::find(arrays.begin(), arrays.end(), nullptr) == arrays.end(); };
  if (all(degrees))
  {
    this->Grid->GetCellData()->SetHigherOrderDegrees(joinCellValues(this->Shared, degrees));
  }
  if (all(weights))
  {
    this->Grid->GetPointData()->SetRationalWeights(joinPointValues(this->Shared, weights));
  }
}

std::string JoinedBlocks::joinScalars(const std::vector<Block>& drawn)
{
  std::vector<vtkDataArray*> arrays;
  for (const Block& block : drawn)
  {
    const std::string wrong = checkScalars(block.Data, block.Scalars, this->CellScalars);
    if (!wrong.empty())
    {
      return of(block) + wrong;
    }
    arrays.push_back(block.Scalars);
  }
  if (vtkUnstructuredGrid* grid = onlyGridOf(drawn))
  {
    this->Grid = grid;
    this->Scalars = arrays.front();
  }
  else if (!drawn.empty())
  {
    this->Scalars = this->CellScalars ? joinCellValues(this->Shared, arrays)
                                      : joinPointValues(this->Shared, arrays);
    if (!this->CellScalars && valuesDiffer(this->Shared, arrays, this->Scalars))
    {
      this->Shared.Places = repeatShared(this->Shared.Points, this->Shared.Count);
      this->joinGrid();
      this->Scalars = joinPointValues(this->Shared, arrays);
    }
  }
  return {};
}

std::string JoinedBlocks::cutCurvedCells(const CurvedOptions& options, const Progress& progress)
{
  if (options.Tolerance == 0 || !this->Grid)
  {
    return {};
  }
  std::string error =
    straighten(this->Grid, this->Scalars, this->CellScalars, options, progress, this->Cut);
  if (this->isCut())
  {
    this->CutOrigins = this->Origins;
    this->CutOrigins.renumber(std::move(this->Cut.Cells));
  }
  return error;
}

std::string JoinedBlocks::update(vtkDataObject* input, const ScalarSelection& selection,
  const CurvedOptions& curved, const Progress& progress)
{
  const std::string shortage = withinMemory("joining the blocks",
    [&]
    {
      std::string error;
      const auto blocks = this->Made.replaceIn(input, error);
      if (blocks)
      {
        this->joinChanged(blocks, selection, curved, progress);
      }
      else
      {
        this->restart();
        this->Error = error;
      }
    });
  if (!shortage.empty())
  {
    this->clear();
    return shortage;
  }
  return this->Error;
}

void JoinedBlocks::findBounds(vtkDataObject* input, double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
  auto* tree = vtkHyperTreeGrid::SafeDownCast(input);
  if (tree && checkTree(tree).empty())
  {
    tree->GetBounds(bounds);
    return;
  }
  std::string error; // update() tells of it
  const std::string shortage = withinMemory("the leaves of trees",
    [&]
    {
      if (const auto blocks = this->Made.replaceIn(input, error))
      {
        boundBlocks(blocks, bounds);
        if (this->isCut())
        {
          vtkBoundingBox box(bounds);
          box.AddBounds(this->Cut.Grid->GetBounds());
          box.GetBounds(bounds);
        }
      }
    });
}

void JoinedBlocks::joinChanged(vtkDataObject* input, const ScalarSelection& selection,
  const CurvedOptions& curved, const Progress& progress)
{
  std::vector<Block> blocks = listBlocks(input, selection);
  for (Block& block : blocks)
  {
    this->Made.isOfCellGrid(block.Data) ? chooseOfEither(block, selection) : void();
  }
  Fingerprint shape = shapeOf(blocks);
  const std::string wanted = describe(selection);
  shape.insert(shape.end(), wanted.begin(), wanted.end());
  Fingerprint scalars = scalarsOf(blocks);
  add(scalars, curved.Tolerance);
  const bool isMeasured = !this->isCut() || this->Cut.HasDeparture || !curved.MeasuresDeparture;
  if (shape == this->Shape && scalars == this->ScalarsInput && isMeasured)
  {
    return;
  }
  StageRecorder recorder(this->Record);
  this->Cut = {};
  const bool sameShape = shape == this->Shape && this->Error.empty();
  if (!sameShape)
  {
    this->restart();
    this->Error = this->choose(blocks, selection);
  }
  const std::vector<Block> drawn = this->drawnOf(blocks);
  if (!sameShape && this->Error.empty())
  {
    this->Shared.Refined = refinedCells(input, drawn);
    this->Error = this->join(drawn);
  }
  if (this->Error.empty())
  {
    this->Error = this->joinScalars(drawn);
  }
  if (this->Error.empty())
  {
    this->Error = this->cutCurvedCells(curved, progress);
  }
  if (this->Cut.Stopped)
  {
    this->restart();
    return;
  }
  if (!this->Error.empty())
  {
    this->Grid = nullptr;
  }
  this->Shape = shape;
  this->ScalarsInput = scalars;
}

} // namespace tetmarch
