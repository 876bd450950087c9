// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_FunctionChart_h
#define tetmarch_FunctionChart_h

#include "HistogramPlot.h"
#include "IsoValueItem.h"
#include "ShownFunctions.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <QVTKOpenGLNativeWidget.h>

#include <vector>

class vtkChartXY;
class vtkColorTransferControlPointsItem;
class vtkColorTransferFunction;
class vtkColorTransferFunctionItem;
class vtkCompositeControlPointsItem;
class vtkCompositeTransferFunctionItem;
class vtkContextView;
class vtkControlPointsItem;
class vtkPiecewiseFunction;

namespace tetmarch
{

/// A point of one of the functions.
struct ControlPoint
{
  enum class Kind
  {
    None,
    Opacity,
    Color
  };
  Kind Of = Kind::None;
  int Index = -1;
};

/**
 * The picture of the functions, in which the mouse edits them: the opacity curve over the colours
 * and the histogram, with the lines of isovalues, and below it the bar of colours.
 *
 * A left click adds a point, a drag moves it, a middle click or Delete removes it. A double click
 * on an opacity point shows handles for the curve's midpoint and sharpness.
 */
class FunctionChart : public QVTKOpenGLNativeWidget
{
  Q_OBJECT

public:
  explicit FunctionChart(QWidget* parent = nullptr);
  ~FunctionChart() override;

  /// Functions that are drawn and edited in place.
  void SetFunctions(vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity);

  HistogramPlot& GetHistogram() { return this->Histogram; }
  IsoValueItem* GetIsoValues() { return this->IsoValues; }

  /// Takes values from the least to the greatest of functions and histogram as the width.
  void FitAxes();

  ControlPoint GetChosenPoint() const;
  void ChoosePoint(const ControlPoint& point);

  /// The points at the ends stay: without them the functions would have another range.
  void DeleteChosenPoint();

  /// Where a value and an opacity are drawn, and the middle of the bar at a value.
  QPoint Locate(double value, double opacity) const;
  QPoint LocateInBar(double value) const;

  QSize sizeHint() const override { return { 320, 210 }; }
  QSize minimumSizeHint() const override { return { 160, 130 }; }

Q_SIGNALS:
  void PointChosen();
  void ColorPointDoubleClicked();
  void MousePressed();
  void MouseReleased();
  void IsoValuesDragged();

protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void SetUpCharts();
  void AddPlots();
  void PlaceCharts();
  void LabelAxis(double low, double high);
  void TakePalette();
  QPoint ToWidget(vtkChartXY* chart, double value, double y) const;
  void OpacityPointChosen();
  void ColorPointChosen();
  void ColorPointEdited() { Q_EMIT this->ColorPointDoubleClicked(); }
  void LineDragged() { Q_EMIT this->IsoValuesDragged(); }

  vtkNew<vtkContextView> View;
  vtkNew<vtkChartXY> OpacityChart;
  vtkNew<vtkChartXY> BarChart;
  vtkNew<vtkCompositeTransferFunctionItem> Curve;
  vtkNew<vtkCompositeControlPointsItem> OpacityPoints;
  vtkNew<vtkColorTransferFunctionItem> Bar;
  vtkNew<vtkColorTransferControlPointsItem> ColorPoints;
  vtkNew<IsoValueItem> IsoValues;
  HistogramPlot Histogram;
  ShownFunctions Functions;
  vtkSmartPointer<vtkColorTransferFunction> Color;
  vtkSmartPointer<vtkPiecewiseFunction> Opacity;
  ControlPoint::Kind LastChosen = ControlPoint::Kind::None;
};

} // namespace tetmarch

#endif
