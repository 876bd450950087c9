// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The hidden cells of a lattice, updated when the lattice or the values of a ghost array have
// changed.
#ifndef TetMarchStructuredHiddenLatticeStage_h
#define TetMarchStructuredHiddenLatticeStage_h

#include "Caching/ContentHash.h"
#include "Caching/MadeFrom.h"
#include "Structured/HiddenLatticeCells.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkDataSet;

namespace tetmarch
{

class HiddenLatticeStage
{
public:
  /** latticeRun: the run of the stage that made this lattice. */
  void update(vtkDataSet* data, const std::array<int, 3>& points, const LatticeCase& lies,
    std::int64_t latticeRun);

  /** See hiddenLatticeCells(). */
  const std::vector<std::uint32_t>& cells() const { return this->Cells; }
  /** Equal if the same cells are hidden; empty without ghost arrays. */
  const Fingerprint& version() const { return this->Made.input(); }
  const StageRecord& record() const { return this->Made.record(); }

private:
  void readContent(vtkDataSet* data, const GhostArrays& ghosts);

  Fingerprint Read; // identities and times of change of the hashed arrays
  std::array<ContentHash, 2> Content{};
  std::vector<std::uint32_t> Cells;
  MadeFrom Made;
};

} // namespace tetmarch

#endif
