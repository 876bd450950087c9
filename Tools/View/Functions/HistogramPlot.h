// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_HistogramPlot_h
#define tetmarch_HistogramPlot_h

#include "vtkNew.h"

#include <vector>

class vtkPlotArea;
class vtkTable;

namespace tetmarch
{

/// A histogram behind the functions: steps whose highest is as high as an opacity of 1.
class HistogramPlot
{
public:
  HistogramPlot();
  ~HistogramPlot();

  /// Counts of bins of equal width from low to high; none, or a range without width, shows nothing.
  void SetCounts(const std::vector<double>& counts, double low, double high);

  /// The values at 0 and at 1 of the chart's axis.
  void SetAxis(double low, double high);

  /// Whether heights are logarithms of one more than the counts. Else few cells are hard to see.
  void SetLogarithmic(bool logarithmic);
  bool GetLogarithmic() const { return this->Logarithmic; }

  bool IsEmpty() const { return this->Counts.empty(); }
  double GetLow() const { return this->Low; }
  double GetHigh() const { return this->High; }

  /// The heights of the bins as they are drawn, 0 to 1.
  std::vector<double> GetHeights() const;

  /// Red, green, blue, opacity, 0 to 255.
  void SetColor(unsigned char red, unsigned char green, unsigned char blue, unsigned char opacity);

  vtkPlotArea* GetPlot() { return this->Plot; }

private:
  void FillTable();

  std::vector<double> Counts;
  double Low = 0.0;
  double High = 0.0;
  double AxisLow = 0.0;
  double AxisHigh = 1.0;
  bool Logarithmic = false;
  vtkNew<vtkTable> Table;
  vtkNew<vtkPlotArea> Plot;
};

} // namespace tetmarch

#endif
