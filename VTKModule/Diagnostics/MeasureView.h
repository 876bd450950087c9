// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A measure of the pixels shown in colours, and from which value to which.
#ifndef TetMarchDiagnosticsMeasureView_h
#define TetMarchDiagnosticsMeasureView_h

#include <array>
#include <string>
#include <vector>

class vtkLookupTable;

namespace tetmarch
{

/** By its place among the four numbers of a pixel. */
enum class Measure
{
  Cells = 0,
  Lookups = 1,
  ErrorBound = 2
};

struct MeasureView
{
  Measure What = Measure::Cells;
  bool Automatic = true;           // the range follows from the measures; else it is the one below
  std::array<double, 2> Range{};   // lowest and highest colour
  vtkLookupTable* Table = nullptr; // its scale and range are those of the last frame

  /** Errors spread over decades. */
  bool isLogarithmic() const { return this->What == Measure::ErrorBound; }
};

/** What is wrong with a range that is not automatic, and what to do; empty if nothing is. */
std::string describeBadRange(const MeasureView& view);

/**
 * Round numbers about a measure of the pixels, of which every fifth part of a bar can be labelled:
 * for errors the four decades below the power of ten that none exceeds, for counts 0 to four times
 * a round number. They stay the same while a camera moves a little.
 */
std::array<double, 2> automaticRange(Measure what, const std::vector<float>& measures);

/** Give the table of the view its scale and its range. */
void fitTable(const MeasureView& view, const std::vector<float>& measures);

} // namespace tetmarch

#endif
