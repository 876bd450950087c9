// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_TransferFunctionEditor_h
#define tetmarch_TransferFunctionEditor_h

#include "FunctionHistory.h"

#include "vtkSmartPointer.h"

#include <QWidget>

#include <array>
#include <functional>
#include <string>
#include <vector>

class QAction;
class QLabel;
class QString;
class vtkColorTransferFunction;
class vtkPiecewiseFunction;

namespace tetmarch
{
class ColorMapBox;
class FunctionChart;
class PointPanel;

/**
 * Edits the colours and opacities of a volume in place: by mouse in a chart with the histogram, by
 * numbers, by colour maps and presets, with undo and redo.
 *
 * Its actions are named undo, redo, reset, invert, fit, logarithmic, load and save.
 */
class TransferFunctionEditor : public QWidget
{
  Q_OBJECT

public:
  explicit TransferFunctionEditor(QWidget* parent = nullptr);
  ~TransferFunctionEditor() override;

  /// The functions to edit; what was done to others can't be undone any more.
  void SetFunctions(vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity);

  /// Counts of bins of equal width from low to high.
  void SetHistogram(const std::vector<double>& counts, double low, double high);

  /// Values for which the chart has lines that can be dragged. Emits nothing.
  void SetIsoValues(const std::vector<double>& isoValues);
  std::vector<double> GetIsoValues() const;

  /**
   * Takes the functions of a preset, stretched to the range of the present colours. One without
   * opacity leaves the opacity as it is. What is wrong with a file is shown below the chart.
   */
  void LoadPreset(const QString& path);
  void SavePreset(const QString& path);

  FunctionChart* GetChart() { return this->Chart; }

Q_SIGNALS:
  /// The functions are others now; also while somebody drags.
  void Changed();

  /// Between these two, coarser pictures will do.
  void DragBegan();
  void DragEnded();

  void IsoValuesChanged();

private:
  void MakeActions();
  void LayOut();
  QAction* AddAction(const char* name, const QString& text, const QString& tip, int icon);
  FunctionSnapshot ReadPresent() const;

  /// Changes the functions by a call, as one step of a kind (see FunctionHistory::Record()).
  void Edit(const std::function<void()>& change, const std::string& kind = "");

  /// Makes a state of the history, or one made of it, the present one.
  void Restore(const FunctionSnapshot& state);

  void FunctionsModified();
  void TellOfChanges();
  void BeginPress();
  void EndPress();
  void Refresh();
  void ShowChosenPoint();
  void SetNumber(int field, double number);

  /// What new colours are to span: the range of the present ones or, if they have none, the data's.
  std::array<double, 2> GetColorRange();

  void ChooseColor();
  void SetColor(int index, double red, double green, double blue, const std::string& kind);
  void AskForFile(bool save);
  void ShowMessage(const QString& text);
  void Observe(bool on);

  vtkSmartPointer<vtkColorTransferFunction> Color;
  vtkSmartPointer<vtkPiecewiseFunction> Opacity;
  unsigned long ColorObserver = 0;
  unsigned long OpacityObserver = 0;
  FunctionHistory History;
  FunctionSnapshot Told; ///< what listeners have been told of last
  bool Editing = false;  ///< Edit() tells of all that it did when it is done
  bool Pressed = false;  ///< a mouse button is down in the chart
  bool Dragging = false; ///< and since then something has changed
  int DialogsOpened = 0;

  FunctionChart* Chart = nullptr;
  PointPanel* Panel = nullptr;
  ColorMapBox* Maps = nullptr;
  QLabel* Message = nullptr;
};

} // namespace tetmarch

#endif
