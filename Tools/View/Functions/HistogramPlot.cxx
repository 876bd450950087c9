// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HistogramPlot.h"

#include "vtkBrush.h"
#include "vtkDoubleArray.h"
#include "vtkPen.h"
#include "vtkPlotArea.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{

HistogramPlot::HistogramPlot()
{
  for (const char* const name : { "value", "zero", "height" })
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    this->Table->AddColumn(column);
  }
  this->Plot->SetInteractive(false);
  this->Plot->GetPen()->SetLineType(vtkPen::NO_PEN);
  this->FillTable();
}

HistogramPlot::~HistogramPlot() = default;

void HistogramPlot::SetCounts(const std::vector<double>& counts, double low, double high)
{
  const bool sound = std::isfinite(low) && std::isfinite(high) && low < high;
  this->Counts = sound ? counts : std::vector<double>();
  this->Low = low;
  this->High = high;
  this->FillTable();
}

void HistogramPlot::SetAxis(double low, double high)
{
  if (low != this->AxisLow || high != this->AxisHigh)
  {
    this->AxisLow = low;
    this->AxisHigh = high;
    this->FillTable();
  }
}

void HistogramPlot::SetLogarithmic(bool logarithmic)
{
  this->Logarithmic = logarithmic;
  this->FillTable();
}

std::vector<double> HistogramPlot::GetHeights() const
{
  std::vector<double> heights;
  double highest = 0.0;
  for (const double count : this->Counts)
  {
    const double sound = count > 0.0 && std::isfinite(count) ? count : 0.0;
    heights.push_back(this->Logarithmic ? std::log1p(sound) : sound);
    highest = std::max(highest, heights.back());
  }
  for (double& height : heights)
  {
    height = highest > 0.0 ? height / highest : 0.0;
  }
  return heights;
}

void HistogramPlot::SetColor(
  unsigned char red, unsigned char green, unsigned char blue, unsigned char opacity)
{
  this->Plot->GetBrush()->SetColor(red, green, blue, opacity);
}

void HistogramPlot::FillTable()
{
  // Two points for each bin, at its ends; an area is drawn of two points at least.
  const std::vector<double> heights = this->GetHeights();
  const auto bins = static_cast<vtkIdType>(heights.size());
  this->Table->SetNumberOfRows(std::max<vtkIdType>(2, 2 * bins));
  for (vtkIdType row = 0; row < this->Table->GetNumberOfRows(); ++row)
  {
    const double share =
      bins > 0 ? static_cast<double>((row + 1) / 2) / static_cast<double>(bins) : 0.0;
    const double value = this->Low + share * (this->High - this->Low);
    this->Table->SetValue(row, 0, (value - this->AxisLow) / (this->AxisHigh - this->AxisLow));
    this->Table->SetValue(row, 1, 0.0);
    this->Table->SetValue(row, 2, bins > 0 ? heights[row / 2] : 0.0);
  }
  this->Table->Modified();
  this->Plot->SetInputData(this->Table);
  this->Plot->SetInputArray(0, "value");
  this->Plot->SetInputArray(1, "zero");
  this->Plot->SetInputArray(2, "height");
  this->Plot->SetVisible(bins > 0);
}

} // namespace tetmarch
