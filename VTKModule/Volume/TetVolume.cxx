// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volume/TetVolume.h"

#include "Caching/WithinMemory.h"

namespace tetmarch
{

std::string TetVolume::updateGeometry(
  vtkUnstructuredGrid* grid, const ResourceLimits& limits, const Progress& progress)
{
  if (!this->Meshed.isCurrent(grid, this->Piece))
  {
    this->ScalarsInput.clear();
    this->RangesInput.clear();
    const std::string error = this->Meshed.make(grid, limits, progress, this->Piece);
    if (!error.empty())
    {
      return error;
    }
  }
  return withinMemory(
    "the hidden cells", [&] { this->Hidden.update(grid, this->mesh(), this->meshRecord().Runs); });
}

std::vector<FiniteRange> TetVolume::rangesOf(vtkUnstructuredGrid* grid, const DrawnScalars& drawn)
{
  const Fingerprint input = versionOf(drawn);
  if (input != this->RangesInput)
  {
    this->RangesInput.clear();
    this->Ranges = tetmarch::rangesOf(grid, drawn, this->mesh());
    this->RangesInput = input;
  }
  return this->Ranges;
}

std::string TetVolume::updateScalars(vtkUnstructuredGrid* grid, const DrawnScalars& drawn)
{
  const Fingerprint input = versionOf(drawn);
  if (input == this->ScalarsInput)
  {
    return {};
  }
  this->ScalarsInput.clear();
  const std::string shortage = withinMemory("the scalars",
    [&]
    {
      const StageRecorder recorder(this->ScalarsRecord);
      this->Scalars = {};
      this->Scalars = readScalars(grid, drawn, this->Meshed.mesh());
    });
  if (shortage.empty())
  {
    this->ScalarsInput = input;
    this->ScalarsVersion = { static_cast<std::uintptr_t>(this->meshRecord().Runs),
      static_cast<std::uintptr_t>(this->ScalarsRecord.Runs) };
  }
  return shortage;
}

std::string TetVolume::updateVisiblePart(
  const IntegralTable* table, const Blending& blending, bool undrawnSeen)
{
  return withinMemory("what is visible",
    [&]
    {
      const StageRecorder recorder(this->VisibleRecord);
      this->Visible = {};
      if (table && (blending.isComposite() || blending.isIsoSurface()))
      {
        this->Visible = findVisiblePart(
          this->mesh(), { &this->Scalars, table, &blending, &this->hiddenCells(), undrawnSeen });
      }
    });
}

std::string TetVolume::ensureHierarchy()
{
  if (this->mesh().hasHierarchy())
  {
    return {};
  }
  std::string error;
  const std::string shortage = withinMemory("the hierarchy of the boundary",
    [&]
    {
      error = this->Meshed.addHierarchy();
      if (error.empty())
      {
        linkVisiblePart(this->mesh(), this->Visible);
      }
    });
  return shortage.empty() ? error : shortage;
}

Fingerprint TetVolume::visibleVersion() const
{
  Fingerprint version = this->linksVersion();
  version.push_back(static_cast<std::uintptr_t>(this->VisibleRecord.Runs));
  return version;
}

Fingerprint TetVolume::linksVersion() const
{
  return { static_cast<std::uintptr_t>(this->meshRecord().Runs),
    this->mesh().hasHierarchy() ? std::uintptr_t(1) : 0 };
}

} // namespace tetmarch
