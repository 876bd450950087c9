// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The empty space of a lattice, found again when other scalars are seen or their ranges have
// changed.
#ifndef TetMarchStructuredEmptySpaceStage_h
#define TetMarchStructuredEmptySpaceStage_h

#include "Caching/CachedStage.h"
#include "Structured/EmptySpace.h"

#include <cstdint>
#include <vector>

namespace tetmarch
{

class EmptySpaceStage
{
public:
  /** See findBlockDistances(). rangesRun: the run of the stage that found the ranges of blocks. */
  void update(const std::vector<ShownScalar>& shown, bool undrawnSeen, std::int64_t rangesRun);
  /** The same for isosurfaces. */
  void updateSurfaces(
    const BlockRanges& ranges, const std::vector<float>& isoValues, std::int64_t rangesRun);
  /** No block is known to be empty. */
  void clear();

  const BlockDistances& distances() const { return this->Distances; }
  const StageRecord& record() const { return this->Made.record(); }
  /** Equal as long as the distances are the same. */
  Fingerprint version() const { return this->Made.input(); }

private:
  template <typename Find>
  void update(const Fingerprint& input, const Find& find);

  BlockDistances Distances;
  CachedStage Made;
};

} // namespace tetmarch

#endif
