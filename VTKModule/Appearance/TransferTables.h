// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tables of the transfer functions, made again when a function or a range has changed.
#ifndef TetMarchAppearanceTransferTables_h
#define TetMarchAppearanceTransferTables_h

#include "Appearance/Blending.h"
#include "Appearance/Components.h"
#include "Budget/ResourceLimits.h"
#include "Caching/StageRecord.h"

#include <string>
#include <vector>

namespace tetmarch
{

/** The input of the tables, besides the functions of a vtkVolumeProperty. */
struct TableInput
{
  OpacityLaw Law = OpacityLaw::Unstructured;
  const Blending* Blend = nullptr;
  ComponentMix Mix = ComponentMix::Single;
  ScalarRange Range;                    // of the first scalar
  std::vector<ScalarRange> ExtraRanges; // of extra scalars
  bool HasVariations = false;           // error bounds need those of extinctions and of slopes, too
  std::uint64_t MostEntries = std::numeric_limits<std::uint64_t>::max(); // of all tables together
};

class TransferTables
{
public:
  /** Returns an empty string, or an error. */
  std::string update(
    vtkVolumeProperty* property, const TableInput& input, const AccuracyLevel& level);

  /** The table of the first scalar. */
  const IntegralTable& first() const { return this->First; }
  /** Extra components. */
  const Components& components() const { return this->Parts; }
  /** Whether any table has extinction. */
  bool isVisible() const { return this->Visible; }
  /** Equal if the functions are the same, at any accuracy. */
  const Fingerprint& shown() const { return this->Shown; }
  const StageRecord& record() const { return this->Record; }
  std::vector<BufferSize> bufferSizes() const;

private:
  IntegralTable First;
  Components Parts;
  bool Visible = false;
  Fingerprint Shown;
  Fingerprint MadeFrom;
  StageRecord Record;
};

/** The table of the first scalar; those of extra scalars are stored in the components' Tables.
 * They have at most the input's number of entries. */
IntegralTable makeTables(vtkVolumeProperty* property, const TableInput& input,
  const AccuracyLevel& level, Components& components);

} // namespace tetmarch

#endif
