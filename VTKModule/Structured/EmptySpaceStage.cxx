// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Structured/EmptySpaceStage.h"

#include "Scalars/SeenScalars.h"

namespace tetmarch
{

template <typename Find>
void EmptySpaceStage::update(const Fingerprint& input, const Find& find)
{
  this->Made.update(
    input, [this] { this->Distances = {}; }, [&] { this->Distances = find(); });
}

void EmptySpaceStage::update(
  const std::vector<ShownScalar>& shown, bool undrawnSeen, std::int64_t rangesRun)
{
  Fingerprint input{ static_cast<std::uintptr_t>(rangesRun), undrawnSeen ? 1u : 0u };
  for (const ShownScalar& scalar : shown)
  {
    const std::vector<SeenRun> runs = SeenScalars(*scalar.Table, scalar.Range).runs();
    input.push_back(runs.size());
    for (const SeenRun& run : runs)
    {
      add(input, run.LeastHigh);
      add(input, run.MostLow);
    }
  }
  this->update(input, [&] { return findBlockDistances(shown, undrawnSeen); });
}

void EmptySpaceStage::updateSurfaces(
  const BlockRanges& ranges, const std::vector<float>& isoValues, std::int64_t rangesRun)
{
  constexpr std::uintptr_t surfaces = 2; // in the place of undrawnSeen
  Fingerprint input{ static_cast<std::uintptr_t>(rangesRun), surfaces };
  addAll(input, isoValues);
  this->update(input, [&] { return findBlockDistances(ranges, isoValues); });
}

void EmptySpaceStage::clear()
{
  this->update(Fingerprint(), [] { return BlockDistances(); });
}

} // namespace tetmarch
