// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The transfer functions of several components drawn together.
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

/** The position of a table among consecutive tables, as in Shaders/tables/integral_table.glsl. */
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
  std::vector<ScalarRange> ExtraRanges; // of the extra scalars
  /** The tables after that of the first scalar: one for each extra independent component; for
   * ColorAndOpacity that of the colours, whose extinction is 1; for DirectColor none. */
  std::vector<IntegralTable> Tables;
  /** The extinctions of independent components are multiplied by these: the component's weight
   * times the first unit distance over its own. */
  std::array<double, MostComponents> Factors{ { 1, 1, 1, 1 } };

  bool isSingle() const { return this->Mix == ComponentMix::Single; }
  bool isIndependent() const { return this->Mix == ComponentMix::Independent; }
  int count() const { return static_cast<int>(this->ExtraRanges.size()) + 1; }
  void setBits(VariantKey& key) const;
  /** The positions of the table of the first scalar, which has this range, and of the further
   * tables. */
  std::vector<TablePlace> places(const IntegralTable& first, const ScalarRange& range) const;
  /** Whether an extra table has extinction. */
  bool isExtraVisible() const;
};

/** Set Factors. Returns an empty string, or an error of a unit distance. */
std::string setFactors(vtkVolumeProperty* property, Components& components);

/** Set the Tables of several components, and return that of the first scalar, which has this range.
 */
IntegralTable componentTables(vtkVolumeProperty* property, OpacityLaw law, const ScalarRange& range,
  const AccuracyLevel& level, Components& components);

} // namespace tetmarch

#endif
