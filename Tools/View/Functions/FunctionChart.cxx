// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FunctionChart.h"

#include "vtkAxis.h"
#include "vtkChartXY.h"
#include "vtkColorTransferControlPointsItem.h"
#include "vtkColorTransferFunction.h"
#include "vtkColorTransferFunctionItem.h"
#include "vtkCompositeControlPointsItem.h"
#include "vtkCompositeTransferFunctionItem.h"
#include "vtkContextScene.h"
#include "vtkContextView.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlotArea.h"

#include <algorithm>
#include <cmath>

namespace
{
// Room beside 0 and 1, so that points there are whole.
constexpr double Room = 0.06;
constexpr double SideRoom = 0.025;
} // namespace

namespace tetmarch
{

FunctionChart::FunctionChart(QWidget* parent)
  : QVTKOpenGLNativeWidget(parent)
{
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  this->setRenderWindow(window.Get());
  this->View->SetRenderWindow(window);
  this->View->SetInteractor(this->interactor());
  this->setFocusPolicy(Qt::ClickFocus);
  this->SetUpCharts();
  this->AddPlots();
  this->TakePalette();
}

FunctionChart::~FunctionChart()
{
  for (vtkControlPointsItem* const item : { static_cast<vtkControlPointsItem*>(this->OpacityPoints),
         static_cast<vtkControlPointsItem*>(this->ColorPoints) })
  {
    item->RemoveAllObservers();
  }
}

void FunctionChart::SetUpCharts()
{
  for (vtkChartXY* const chart : { this->OpacityChart.Get(), this->BarChart.Get() })
  {
    chart->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
    chart->SetShowLegend(false);
    chart->SetAutoAxes(false); // else axes come with plots
    chart->SetActionToButton(vtkChart::PAN, -1);
    chart->SetActionToButton(vtkChart::ZOOM, -1);
    chart->SetActionToButton(vtkChart::SELECT, -1);
    chart->SetZoomWithMouseWheel(false);
    for (int side = 0; side < 4; ++side)
    {
      vtkAxis* const axis = chart->GetAxis(side);
      axis->SetVisible(chart == this->BarChart.Get() && side == vtkAxis::BOTTOM);
      axis->SetBehavior(vtkAxis::FIXED);
      axis->SetGridVisible(false);
      axis->SetTitle("");
    }
    chart->GetAxis(vtkAxis::BOTTOM)->SetRange(-SideRoom, 1.0 + SideRoom);
    this->View->GetScene()->AddItem(chart);
  }
  this->OpacityChart->GetAxis(vtkAxis::LEFT)->SetRange(-Room, 1.0 + Room);
  this->BarChart->GetAxis(vtkAxis::LEFT)->SetRange(0.0, 1.0);
}

void FunctionChart::AddPlots()
{
  // From the lowest to the highest: the mouse finds points first, then lines, then where to add.
  this->OpacityPoints->SetPointsFunction(vtkCompositeControlPointsItem::OpacityPointsFunction);
  this->OpacityPoints->SetUseOpacityPointHandles(true);
  this->OpacityPoints->SetColorFill(true);
  this->ColorPoints->SetColorFill(true);
  for (vtkControlPointsItem* const item : { static_cast<vtkControlPointsItem*>(this->OpacityPoints),
         static_cast<vtkControlPointsItem*>(this->ColorPoints) })
  {
    item->SetEndPointsXMovable(false);
    item->SetEndPointsRemovable(false);
    item->UseAddPointItemOn();
  }
  this->Curve->SetMaskAboveCurve(true);
  this->OpacityChart->AddPlot(this->Histogram.GetPlot());
  this->OpacityChart->AddPlot(this->OpacityPoints->GetAddPointItem());
  this->OpacityChart->AddPlot(this->Curve);
  this->OpacityChart->AddPlot(this->IsoValues);
  this->OpacityChart->AddPlot(this->OpacityPoints);
  this->BarChart->AddPlot(this->ColorPoints->GetAddPointItem());
  this->BarChart->AddPlot(this->Bar);
  this->BarChart->AddPlot(this->ColorPoints);
  this->Curve->SetColorTransferFunction(this->Functions.GetColors());
  this->Curve->SetOpacityFunction(this->Functions.GetOpacity());
  this->OpacityPoints->SetColorTransferFunction(this->Functions.GetColors());
  this->OpacityPoints->SetOpacityFunction(this->Functions.GetOpacity());
  this->Bar->SetColorTransferFunction(this->Functions.GetColors());
  this->ColorPoints->SetColorTransferFunction(this->Functions.GetColorPoints());
  this->OpacityPoints->SetUserBounds(0.0, 1.0, 0.0, 1.0);
  this->OpacityPoints->SetValidBounds(0.0, 1.0, 0.0, 1.0);
  this->ColorPoints->SetUserBounds(0.0, 1.0, 0.0, 1.0);
  this->ColorPoints->SetValidBounds(0.0, 1.0, 0.0, 1.0);
  this->Curve->SetInteractive(false);
  this->Bar->SetInteractive(false);

  this->OpacityPoints->AddObserver(
    vtkControlPointsItem::CurrentPointChangedEvent, this, &FunctionChart::OpacityPointChosen);
  this->ColorPoints->AddObserver(
    vtkControlPointsItem::CurrentPointChangedEvent, this, &FunctionChart::ColorPointChosen);
  this->ColorPoints->AddObserver(
    vtkControlPointsItem::CurrentPointEditEvent, this, &FunctionChart::ColorPointEdited);
  this->IsoValues->AddObserver(vtkCommand::InteractionEvent, this, &FunctionChart::LineDragged);
}

void FunctionChart::SetFunctions(vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity)
{
  this->Color = color;
  this->Opacity = opacity;
  this->Functions.SetFunctions(color, opacity);
  this->ChoosePoint({});
  this->FitAxes();
}

void FunctionChart::FitAxes()
{
  double low = this->Histogram.IsEmpty() ? HUGE_VAL : this->Histogram.GetLow();
  double high = this->Histogram.IsEmpty() ? -HUGE_VAL : this->Histogram.GetHigh();
  if (this->Color && this->Color->GetSize() > 0)
  {
    low = std::min(low, this->Color->GetRange()[0]);
    high = std::max(high, this->Color->GetRange()[1]);
  }
  if (this->Opacity && this->Opacity->GetSize() > 0)
  {
    low = std::min(low, this->Opacity->GetRange()[0]);
    high = std::max(high, this->Opacity->GetRange()[1]);
  }
  for (const double value : this->IsoValues->GetIsoValues())
  {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (!(low <= high))
  {
    low = 0.0;
    high = 1.0;
  }
  if (low == high)
  {
    const double some = low == 0.0 ? 1.0 : 0.01 * std::abs(low);
    low -= some;
    high += some;
  }
  this->Functions.SetAxis(low, high);
  this->Histogram.SetAxis(low, high);
  this->IsoValues->SetAxis(low, high);
  this->LabelAxis(low, high);
  this->PlaceCharts();
  this->update();
}

ControlPoint FunctionChart::GetChosenPoint() const
{
  vtkControlPointsItem* const item = this->LastChosen == ControlPoint::Kind::Color
                                       ? static_cast<vtkControlPointsItem*>(this->ColorPoints)
                                       : static_cast<vtkControlPointsItem*>(this->OpacityPoints);
  const auto index = static_cast<int>(item->GetCurrentPoint());
  if (this->LastChosen == ControlPoint::Kind::None || index < 0 ||
      index >= item->GetNumberOfPoints())
  {
    return {};
  }
  return { this->LastChosen, index };
}

void FunctionChart::ChoosePoint(const ControlPoint& point)
{
  this->OpacityPoints->SetCurrentPoint(point.Of == ControlPoint::Kind::Opacity ? point.Index : -1);
  this->ColorPoints->SetCurrentPoint(point.Of == ControlPoint::Kind::Color ? point.Index : -1);
  this->LastChosen = point.Of;
  Q_EMIT this->PointChosen();
}

void FunctionChart::OpacityPointChosen()
{
  if (this->OpacityPoints->GetCurrentPoint() >= 0)
  {
    this->LastChosen = ControlPoint::Kind::Opacity;
    this->ColorPoints->SetCurrentPoint(-1);
  }
  Q_EMIT this->PointChosen();
}

void FunctionChart::ColorPointChosen()
{
  if (this->ColorPoints->GetCurrentPoint() >= 0)
  {
    this->LastChosen = ControlPoint::Kind::Color;
    this->OpacityPoints->SetCurrentPoint(-1);
  }
  Q_EMIT this->PointChosen();
}

void FunctionChart::DeleteChosenPoint()
{
  switch (this->GetChosenPoint().Of)
  {
    case ControlPoint::Kind::Opacity:
      this->OpacityPoints->RemoveCurrentPoint();
      break;
    case ControlPoint::Kind::Color:
      this->ColorPoints->RemoveCurrentPoint();
      break;
    case ControlPoint::Kind::None:
      break;
  }
}

QPoint FunctionChart::ToWidget(vtkChartXY* chart, double value, double y) const
{
  const auto along = [&](int side, double place)
  {
    vtkAxis* const axis = chart->GetAxis(side);
    return (place - axis->GetMinimum()) / (axis->GetMaximum() - axis->GetMinimum());
  };
  const auto rect = chart->GetSize().Cast<double>(); // left, bottom, width, height
  const double ratio = this->devicePixelRatioF();
  const double right = rect[0] + along(vtkAxis::BOTTOM, this->Functions.ToAxis(value)) * rect[2];
  const double up = rect[1] + along(vtkAxis::LEFT, y) * rect[3];
  return { static_cast<int>(std::lround(right / ratio)),
    static_cast<int>(std::lround(this->height() - 1 - up / ratio)) };
}

QPoint FunctionChart::Locate(double value, double opacity) const
{
  return this->ToWidget(this->OpacityChart, value, opacity);
}

QPoint FunctionChart::LocateInBar(double value) const
{
  return this->ToWidget(this->BarChart, value, 0.5);
}

} // namespace tetmarch
