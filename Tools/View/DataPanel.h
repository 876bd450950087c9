// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What of the data is drawn: array, component, blend mode, isovalues, density.
 */
#ifndef tetmarch_DataPanel_h
#define tetmarch_DataPanel_h

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;

namespace tetmarch
{
class Model;
class ValueSlider;

class DataPanel : public QWidget
{
  Q_OBJECT

public:
  explicit DataPanel(Model& model, QWidget* parent = nullptr);

private:
  void ShowData();
  void ShowState();
  void TakeArray(int index);
  void TakeComponent(int index);
  void TakeIsoValues();

  Model& Shown;
  QLabel* Summary;
  QComboBox* Array;
  QComboBox* Component;
  QComboBox* Blend;
  QLineEdit* IsoValues;
  ValueSlider* Density;
  QCheckBox* Nearest;
};

} // namespace tetmarch

#endif
