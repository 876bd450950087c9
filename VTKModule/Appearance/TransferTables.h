// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tables of the transfer functions, made anew when a function or a range changed.
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

/** What tables are made of, beside the functions of a vtkVolumeProperty. */
struct TableInput
{
  OpacityLaw Law = OpacityLaw::Unstructured;
  const Blending* Blend = nullptr;
  ComponentMix Mix = ComponentMix::Single;
  ScalarRange Range;                      // of the first scalar
  std::vector<ScalarRange> FurtherRanges; // of those that are drawn with it
  bool Bends = false; // the scalar bends along rays, so that error bounds need more of a table
  std::uint64_t MostEntries = std::numeric_limits<std::uint64_t>::max(); // of all tables together
};

class TransferTables
{
public:
  /** Returns an empty string, or what is wrong. */
  std::string update(
    vtkVolumeProperty* property, const TableInput& input, const AccuracyLevel& level);

  /** Of the first scalar. */
  const IntegralTable& first() const { return this->First; }
  /** Of what is drawn with it. */
  const Components& components() const { return this->Parts; }
  /** Whether anything has extinction. */
  bool isVisible() const { return this->Visible; }
  /** Equal if the same is shown, however accurately. */
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

/** The table of the first scalar; those of what is drawn with it become the components' Tables. */
IntegralTable makeTables(vtkVolumeProperty* property, const TableInput& input,
  const AccuracyLevel& level, Components& components);

} // namespace tetmarch

#endif
