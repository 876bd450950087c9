// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A view of a measure of the pixels in colours, and its range.
#ifndef TetMarchDiagnosticsMeasureView_h
#define TetMarchDiagnosticsMeasureView_h

#include <array>
#include <string>
#include <vector>

class vtkLookupTable;

namespace tetmarch
{

/** The index among the four numbers of a pixel. The last one is 1 if the pixel is interpolated, so
 * that its error bound says nothing. */
enum class Measure
{
  Cells = 0,
  Lookups = 1,
  ErrorBound = 2
};

struct MeasureView
{
  Measure What = Measure::Cells;
  bool Automatic = true;           // the range follows from the measures; else it is Range
  std::array<double, 2> Range{};   // lowest and highest colour
  vtkLookupTable* Table = nullptr; // its scale and range are those of the last frame

  /** Errors span decades. */
  bool isLogarithmic() const { return this->What == Measure::ErrorBound; }
};

/** The error of a range that is not automatic, with its remedy; empty if it is valid. */
std::string describeBadRange(const MeasureView& view);

/**
 * A rounded range of a measure, for labels at every fifth of a bar: for errors the four decades
 * below the power of ten that none exceeds, for counts 0 to four times a round number. It is stable
 * for small moves of the camera.
 */
std::array<double, 2> automaticRange(Measure what, const std::vector<float>& measures);

/** Give the table of the view its scale and its range. */
void fitTable(const MeasureView& view, const std::vector<float>& measures);

} // namespace tetmarch

#endif
