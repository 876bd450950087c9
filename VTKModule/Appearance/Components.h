// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Several components of an array, drawn together.
#ifndef TetMarchAppearanceComponents_h
#define TetMarchAppearanceComponents_h

#include "Optics/FittingTable.h"
#include "Scalars/DrawnScalars.h"
#include "Scalars/StoredScalar.h"

#include <array>
#include <string>
#include <vector>

namespace tetmarch
{

struct VariantKey;

/** Where a table is among those that lie behind each other, as in
 * Shaders/tables/integral_table.glsl. */
struct TablePlace
{
  int First;
  int Size;
  std::array<double, 4> IntegralUnit;
  double Scale;
  double Offset;
};

struct Components
{
  ComponentMix Mix = ComponentMix::Single;
  std::vector<ScalarRange> FurtherRanges; // of the scalars behind the first
  /** Behind the table of the first scalar: one each of further independent ones; of ColorAndOpacity
   * that of the colours, whose extinction is 1; of DirectColor none. */
  std::vector<IntegralTable> Tables;
  /** What extinctions of independent components are multiplied by: their weights, and how much
   * shorter their unit distances are than that of the first. */
  std::array<double, MostComponents> Factors{ { 1, 1, 1, 1 } };

  bool isSingle() const { return this->Mix == ComponentMix::Single; }
  bool isIndependent() const { return this->Mix == ComponentMix::Independent; }
  int count() const { return static_cast<int>(this->FurtherRanges.size()) + 1; }
  void setBits(VariantKey& key) const;
  /** Of the table of the first scalar, which has that range, and of those behind it. */
  std::vector<TablePlace> places(const IntegralTable& first, const ScalarRange& range) const;
  /** Whether something has extinction in a table behind the first. */
  bool isFurtherVisible() const;
};

/** Sets Factors. Returns an empty string, or which unit distance is wrong. */
std::string setFactors(vtkVolumeProperty* property, Components& components);

/** Sets the Tables of several components, and returns that of the first scalar, which has that
 * range. */
IntegralTable componentTables(vtkVolumeProperty* property, OpacityLaw law, const ScalarRange& range,
  const AccuracyLevel& level, Components& components);

} // namespace tetmarch

#endif
