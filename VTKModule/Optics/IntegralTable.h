// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Tables of the transfer functions and their integrals for the march (see
// Shaders/tables/integral_table.glsl).
#ifndef TetMarchOpticsIntegralTable_h
#define TetMarchOpticsIntegralTable_h

#include "Optics/TableTraits.h"
#include "Optics/TransferFunctions.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tetmarch
{

struct IntegralTable
{
  std::vector<std::array<float, 4>> Values;            // r, g, b, extinction at each entry
  std::vector<std::array<std::uint32_t, 4>> Integrals; // of C tau and tau up to each entry
  std::vector<float> Variations;                       // total variation of C up to each entry
  std::vector<float> ExtinctionVariations;             // the same of tau, if requested
  /** The same of the slopes of tau and of C tau per entry, if requested. */
  std::vector<std::array<float, 2>> SlopeVariations;
  std::array<double, 4> IntegralUnit{}; // the unit of Integrals, in bins
  TableTraits Traits;
  /** r, g, b, extinction of scalars that are not finite. */
  std::array<float, 4> NanColor{};
  double Begin = 0; // scalars of the first and last sample, which are entries 2 and n - 3
  double End = 1;

  int size() const { return static_cast<int>(this->Values.size()); }

  /** The position in the table, in entries, of a stored scalar s = 0..1 between low and low + width
   * is scale s + offset. */
  double scale(double width) const;
  double offset(double low) const;
};

/** A table of four more entries than samples; its first and last bins contain the constant values
 * below and above the samples. */
IntegralTable makeIntegralTable(const SampledFunctions& functions);

/** Whether any entry has extinction. */
bool hasExtinction(const IntegralTable& table);

/** Add ExtinctionVariations, which the error bounds of several tables and of scalars that bend
 * along a ray need. */
void addExtinctionVariations(IntegralTable& table);

/** Add SlopeVariations, which the error bounds of scalars that bend along a ray, and of curved
 * cells need. */
void addSlopeVariations(IntegralTable& table);

/** The number of samples for a table with this number of entries. */
constexpr int samplesOfTable(int entries) { return entries - 4; }

} // namespace tetmarch

#endif
