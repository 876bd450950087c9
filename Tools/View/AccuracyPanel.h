// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How exact the picture is, and what that takes.
 */
#ifndef tetmarch_AccuracyPanel_h
#define tetmarch_AccuracyPanel_h

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace tetmarch
{
class ErrorTimePlot;
class Model;
class ValueSlider;

class AccuracyPanel : public QWidget
{
  Q_OBJECT

public:
  explicit AccuracyPanel(Model& model, QWidget* parent = nullptr);

  ErrorTimePlot* GetPlot() { return this->Plot; }

protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  void MakeSettings();
  void MakeFigures();
  void ShowState();
  void ShowCurved();
  void ShowTime();
  void ShowFigures();
  void Compare();
  QString DescribeSetting() const;

  Model& Shown;
  QComboBox* Level;
  ValueSlider* Tolerance;
  QComboBox* Curved;
  QCheckBox* Budgeted;
  ValueSlider* Budget;
  QComboBox* View;
  QLabel* Seconds;
  QLabel* Used;
  QLabel* Cells;
  QLabel* Lookups;
  QLabel* Bound;
  QLabel* TrueError;
  QPushButton* CompareButton;
  ErrorTimePlot* Plot;
};

} // namespace tetmarch

#endif
