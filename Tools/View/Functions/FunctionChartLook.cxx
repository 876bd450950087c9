// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the parts of the chart are, and their colours: those of the widget's palette.
#include "FunctionChart.h"

#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkChartXY.h"
#include "vtkColorTransferControlPointsItem.h"
#include "vtkCompositeControlPointsItem.h"
#include "vtkCompositeTransferFunctionItem.h"
#include "vtkContextScene.h"
#include "vtkContextView.h"
#include "vtkDoubleArray.h"
#include "vtkPen.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
// In pixels of a screen that has 96 of them in an inch.
constexpr float Margin = 12.0f;
constexpr float LabelHeight = 20.0f;
constexpr float BarHeight = 22.0f;
constexpr float PointRadius = 5.0f;

void SetPen(vtkPen* pen, const QColor& color, float width)
{
  pen->SetColor(static_cast<unsigned char>(color.red()), static_cast<unsigned char>(color.green()),
    static_cast<unsigned char>(color.blue()));
  pen->SetWidth(width);
}
} // namespace

namespace tetmarch
{

void FunctionChart::PlaceCharts()
{
  const auto ratio = static_cast<float>(this->devicePixelRatioF());
  const float margin = Margin * ratio;
  const float bottom = LabelHeight * ratio;
  const float bar = BarHeight * ratio;
  const float width = std::max(1.0f, static_cast<float>(this->width()) * ratio - 2 * margin);
  const float height =
    static_cast<float>(this->height()) * ratio - bottom - bar - Margin * ratio / 3;
  this->BarChart->SetSize(vtkRectf(margin, bottom, width, bar));
  this->OpacityChart->SetSize(vtkRectf(margin, bottom + bar, width, std::max(1.0f, height)));
  this->OpacityPoints->SetScreenPointRadius(PointRadius * ratio);
  // The many points of a colour map are smaller, so that they stand apart.
  const auto points = static_cast<float>(this->ColorPoints->GetNumberOfPoints());
  this->ColorPoints->SetScreenPointRadius(
    std::min(PointRadius * ratio, 0.3f * width / std::max(1.0f, points)));
  this->IsoValues->SetPixelRatio(static_cast<double>(ratio));
  this->View->GetScene()->SetDirty(true);
}

void FunctionChart::LabelAxis(double low, double high)
{
  // Steps of 1, 2 or 5 times a power of ten, about four per chart.
  const double rough = (high - low) / 4.0;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double step = (rough < 1.5 * power ? 1.0 : rough < 3.5 * power ? 2.0 : 5.0) * power;
  const double most = std::max(std::abs(low), std::abs(high));
  const bool isPlain = most < 1e7 && step > 1e-5;
  const double order = std::floor(std::log10(step) + 1e-9);
  const int decimals = static_cast<int>(std::max(0.0, -order));
  const int digits = static_cast<int>(std::ceil(std::log10(most) - order)) + 1;
  vtkNew<vtkDoubleArray> places;
  vtkNew<vtkStringArray> labels;
  for (double tick = std::ceil(low / step); tick * step <= high; tick += 1.0)
  {
    places->InsertNextValue(this->Functions.ToAxis(tick * step));
    labels->InsertNextValue((isPlain ? QString::number(tick * step, 'f', decimals)
                                     : QString::number(tick * step, 'g', std::clamp(digits, 1, 17)))
                              .toStdString());
  }
  this->BarChart->GetAxis(vtkAxis::BOTTOM)->SetCustomTickPositions(places, labels);
}

void FunctionChart::TakePalette()
{
  const auto ratio = static_cast<float>(this->devicePixelRatioF());
  const QColor base = this->palette().color(QPalette::Base);
  const QColor text = this->palette().color(QPalette::Text);
  const QColor accent = this->palette().color(QPalette::Highlight);
  const auto channel = [](int value) { return static_cast<unsigned char>(value); };
  this->View->GetRenderer()->SetBackground(base.redF(), base.greenF(), base.blueF());
  this->Histogram.SetColor(channel(text.red()), channel(text.green()), channel(text.blue()), 70);
  vtkAxis* const axis = this->BarChart->GetAxis(vtkAxis::BOTTOM);
  SetPen(axis->GetPen(), text, ratio);
  axis->GetLabelProperties()->SetColor(text.redF(), text.greenF(), text.blueF());
  axis->GetLabelProperties()->SetFontSize(static_cast<int>(10 * ratio));
  axis->SetTickLength(3 * ratio);
  axis->SetLabelOffset(5 * ratio);
  for (vtkControlPointsItem* const item : { static_cast<vtkControlPointsItem*>(this->OpacityPoints),
         static_cast<vtkControlPointsItem*>(this->ColorPoints) })
  {
    SetPen(item->GetPen(), text, 1.5f * ratio);
    SetPen(item->GetSelectedPointPen(), accent, 2.5f * ratio);
  }
  SetPen(this->Curve->GetPolyLinePen(), text, 1.5f * ratio);
  SetPen(this->IsoValues->GetPen(), accent, 1.5f * ratio);
  this->IsoValues->GetBrush()->SetColor(
    channel(accent.red()), channel(accent.green()), channel(accent.blue()), 255);
  this->View->GetScene()->SetDirty(true);
  this->update();
}

} // namespace tetmarch
