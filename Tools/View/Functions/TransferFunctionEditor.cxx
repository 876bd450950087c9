// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TransferFunctionEditor.h"

#include "ColorMapBox.h"
#include "FunctionChart.h"
#include "PointPanel.h"

#include "vtkColorTransferFunction.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"

#include <QAction>
#include <QLabel>

namespace tetmarch
{

TransferFunctionEditor::TransferFunctionEditor(QWidget* parent)
  : QWidget(parent)
  , Chart(new FunctionChart(this))
  , Panel(new PointPanel(this))
  , Maps(new ColorMapBox(this))
  , Message(new QLabel(this))
{
  this->MakeActions();
  this->LayOut();
  QObject::connect(this->Chart, &FunctionChart::MousePressed, this, [this] { this->BeginPress(); });
  QObject::connect(this->Chart, &FunctionChart::MouseReleased, this, [this] { this->EndPress(); });
  QObject::connect(
    this->Chart, &FunctionChart::PointChosen, this, [this] { this->ShowChosenPoint(); });
  QObject::connect(
    this->Chart, &FunctionChart::IsoValuesDragged, this, [this] { this->TellOfChanges(); });

  // Until it is given functions, it has some of its own.
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
  color->AddRGBPoint(1.0, 1.0, 1.0, 1.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(1.0, 1.0);
  this->SetFunctions(color, opacity);
}

TransferFunctionEditor::~TransferFunctionEditor() { this->Observe(false); }

void TransferFunctionEditor::Observe(bool on)
{
  if (on)
  {
    this->ColorObserver = this->Color->AddObserver(
      vtkCommand::ModifiedEvent, this, &TransferFunctionEditor::FunctionsModified);
    this->OpacityObserver = this->Opacity->AddObserver(
      vtkCommand::ModifiedEvent, this, &TransferFunctionEditor::FunctionsModified);
  }
  else if (this->Color)
  {
    this->Color->RemoveObserver(this->ColorObserver);
    this->Opacity->RemoveObserver(this->OpacityObserver);
  }
}

void TransferFunctionEditor::SetFunctions(
  vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity)
{
  this->Observe(false);
  this->Color = color;
  this->Opacity = opacity;
  this->Observe(true);
  this->Chart->SetFunctions(color, opacity);
  this->Told = this->ReadPresent();
  this->History.Start(this->Told);
  this->Refresh();
}

void TransferFunctionEditor::SetHistogram(
  const std::vector<double>& counts, double low, double high)
{
  this->Chart->GetHistogram().SetCounts(counts, low, high);
  this->Refresh();
}

void TransferFunctionEditor::SetIsoValues(const std::vector<double>& isoValues)
{
  this->Chart->GetIsoValues()->SetIsoValues(isoValues);
  this->Told.IsoValues = isoValues;
  this->History.ReplaceIsoValues(isoValues);
  this->Refresh();
}

std::vector<double> TransferFunctionEditor::GetIsoValues() const
{
  return this->Chart->GetIsoValues()->GetIsoValues();
}

FunctionSnapshot TransferFunctionEditor::ReadPresent() const
{
  FunctionSnapshot state = TakeSnapshot(this->Color, this->Opacity);
  state.IsoValues = this->GetIsoValues();
  return state;
}

void TransferFunctionEditor::Edit(const std::function<void()>& change, const std::string& kind)
{
  this->Editing = true;
  change();
  this->Editing = false;
  this->History.Record(this->ReadPresent(), kind);
  this->TellOfChanges();
}

void TransferFunctionEditor::Restore(const FunctionSnapshot& state)
{
  this->Editing = true;
  // A chosen point would have the number of another one.
  this->Chart->ChoosePoint({});
  ApplySnapshot(state, this->Color, this->Opacity);
  this->Chart->GetIsoValues()->SetIsoValues(state.IsoValues);
  this->Editing = false;
  this->TellOfChanges();
}

void TransferFunctionEditor::FunctionsModified()
{
  if (!this->Editing)
  {
    this->TellOfChanges();
  }
}

void TransferFunctionEditor::TellOfChanges()
{
  const FunctionSnapshot present = this->ReadPresent();
  if (present == this->Told)
  {
    return;
  }
  const bool linesMoved = present.IsoValues != this->Told.IsoValues;
  this->Told.IsoValues = present.IsoValues;
  const bool functionsChanged = present != this->Told;
  this->Told = present;
  if (this->Pressed)
  {
    if (!this->Dragging)
    {
      this->Dragging = true;
      Q_EMIT this->DragBegan();
    }
    this->ShowChosenPoint();
  }
  else
  {
    // What is in the history already is no step; what somebody else did to the functions is one.
    this->History.Record(present);
    this->Refresh();
  }
  this->ShowMessage({});
  if (functionsChanged)
  {
    Q_EMIT this->Changed();
  }
  if (linesMoved)
  {
    Q_EMIT this->IsoValuesChanged();
  }
}

void TransferFunctionEditor::BeginPress() { this->Pressed = true; }

void TransferFunctionEditor::EndPress()
{
  this->Pressed = false;
  if (this->Dragging)
  {
    this->Dragging = false;
    this->History.Record(this->Told);
    this->Refresh();
    Q_EMIT this->DragEnded();
  }
}

void TransferFunctionEditor::Refresh()
{
  this->Chart->FitAxes();
  this->Maps->ShowMapOf(this->Color);
  this->ShowChosenPoint();
  const auto enable = [&](const char* name, bool on)
  { this->findChild<QAction*>(name)->setEnabled(on); };
  enable("undo", this->History.CanUndo());
  enable("redo", this->History.CanRedo());
  enable("fit", !this->Chart->GetHistogram().IsEmpty());
  enable("logarithmic", !this->Chart->GetHistogram().IsEmpty());
  enable("reset", this->Told != this->History.GetFirst());
}

void TransferFunctionEditor::ShowMessage(const QString& text)
{
  this->Message->setText(text);
  this->Message->setVisible(!text.isEmpty());
}

} // namespace tetmarch
