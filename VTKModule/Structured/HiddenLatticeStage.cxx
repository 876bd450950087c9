// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Structured/HiddenLatticeStage.h"

#include "vtkDataSet.h"
#include "vtkUnsignedCharArray.h"

namespace tetmarch
{

// Code that blanks a cell may call only Modified() of the data.
void HiddenLatticeStage::readContent(vtkDataSet* data, const GhostArrays& ghosts)
{
  Fingerprint read;
  add(read, data);
  add(read, ghosts.OfCells);
  add(read, ghosts.OfPoints);
  if (read != this->Read)
  {
    this->Content = { { contentHashOf(ghosts.OfCells), contentHashOf(ghosts.OfPoints) } };
    this->Read = read;
  }
}

void HiddenLatticeStage::update(vtkDataSet* data, const std::array<int, 3>& points,
  const LatticeCase& lies, std::int64_t latticeRun)
{
  const GhostArrays ghosts = ghostArraysOf(data);
  this->readContent(data, ghosts);
  Fingerprint input;
  if (ghosts.OfCells || ghosts.OfPoints)
  {
    input.push_back(static_cast<std::uintptr_t>(latticeRun));
    for (const ContentHash& hash : this->Content)
    {
      input.insert(input.end(), hash.begin(), hash.end());
    }
  }
  this->Made.update(
    input, [this] { this->Cells = {}; },
    [&] { this->Cells = hiddenLatticeCells(ghosts, points, lies); });
}

} // namespace tetmarch
