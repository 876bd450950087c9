// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The buttons of the editor, and how its parts are arranged.
#include "ColorMapBox.h"
#include "ColorMaps.h"
#include "FunctionChart.h"
#include "FunctionEdits.h"
#include "PointPanel.h"
#include "TransferFunctionEditor.h"

#include "vtkColorTransferFunction.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

namespace
{
constexpr int NoIcon = -1;

QToolButton* MakeButton(QAction* action, QWidget* parent)
{
  auto* const button = new QToolButton(parent);
  button->setDefaultAction(action);
  button->setAutoRaise(true);
  button->setToolButtonStyle(
    action->icon().isNull() ? Qt::ToolButtonTextOnly : Qt::ToolButtonIconOnly);
  return button;
}
} // namespace

namespace tetmarch
{

QAction* TransferFunctionEditor::AddAction(
  const char* name, const QString& text, const QString& tip, int icon)
{
  auto* const action = new QAction(text, this);
  action->setObjectName(name);
  action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  action->setToolTip(tip);
  if (icon != NoIcon)
  {
    action->setIcon(this->style()->standardIcon(static_cast<QStyle::StandardPixmap>(icon)));
  }
  this->addAction(action);
  return action;
}

void TransferFunctionEditor::MakeActions()
{
  QAction* const undo =
    this->AddAction("undo", tr("Undo"), tr("Undo (Ctrl+Z)"), QStyle::SP_ArrowBack);
  undo->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Z));
  QObject::connect(
    undo, &QAction::triggered, this, [this] { this->Restore(this->History.Undo()); });
  QAction* const redo =
    this->AddAction("redo", tr("Redo"), tr("Redo (Ctrl+Shift+Z)"), QStyle::SP_ArrowForward);
  redo->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z));
  QObject::connect(
    redo, &QAction::triggered, this, [this] { this->Restore(this->History.Redo()); });

  const auto edit = [this](QAction* action, auto change)
  {
    QObject::connect(action, &QAction::triggered, this,
      [this, change]
      {
        const FunctionSnapshot state = change();
        this->History.Record(state);
        this->Restore(state);
      });
  };
  edit(this->AddAction("invert", tr("Invert"), tr("Colors from right to left"), NoIcon),
    [this] { return InvertColors(this->Told); });
  edit(this->AddAction(
         "fit", tr("Fit"), tr("Stretch both functions to the range of the data"), NoIcon),
    [this]
    {
      const HistogramPlot& histogram = this->Chart->GetHistogram();
      return FitToRange(this->Told, histogram.GetLow(), histogram.GetHigh());
    });
  edit(this->AddAction("reset", tr("Reset"), tr("Functions as they were at first"), NoIcon),
    [this]
    {
      FunctionSnapshot first = this->History.GetFirst();
      first.IsoValues = this->Told.IsoValues;
      return first;
    });

  QAction* const logarithmic =
    this->AddAction("logarithmic", tr("Log"), tr("Logarithmic heights of the histogram"), NoIcon);
  logarithmic->setCheckable(true);
  QObject::connect(logarithmic, &QAction::toggled, this,
    [this](bool on)
    {
      this->Chart->GetHistogram().SetLogarithmic(on);
      this->Refresh();
    });

  QAction* const load =
    this->AddAction("load", tr("Load"), tr("Load a preset..."), QStyle::SP_DialogOpenButton);
  QObject::connect(load, &QAction::triggered, this, [this] { this->AskForFile(false); });
  QAction* const save =
    this->AddAction("save", tr("Save"), tr("Save as a preset..."), QStyle::SP_DialogSaveButton);
  QObject::connect(save, &QAction::triggered, this, [this] { this->AskForFile(true); });

  QObject::connect(this->Maps, &ColorMapBox::MapChosen, this,
    [this](const QString& name)
    {
      this->Chart->ChoosePoint({});
      const auto range = this->GetColorRange();
      this->Edit([&] { ApplyColorMap(name.toStdString(), range[0], range[1], this->Color); });
    });
  QObject::connect(this->Panel, &PointPanel::NumberEdited, this,
    [this](int field, double number) { this->SetNumber(field, number); });
  QObject::connect(this->Panel, &PointPanel::ColorAskedFor, this, [this] { this->ChooseColor(); });
  QObject::connect(
    this->Chart, &FunctionChart::ColorPointDoubleClicked, this, [this] { this->ChooseColor(); });
}

void TransferFunctionEditor::LayOut()
{
  auto* const layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(4);
  const auto addRow = [&](QWidget* first, std::initializer_list<const char*> names)
  {
    auto* const row = new QHBoxLayout;
    row->setSpacing(1);
    if (first)
    {
      row->addWidget(first, 1);
    }
    for (const char* const name : names)
    {
      row->addWidget(MakeButton(this->findChild<QAction*>(name), this));
    }
    if (!first)
    {
      row->addStretch(1);
    }
    layout->addLayout(row);
  };
  addRow(this->Maps, { "load", "save", "undo", "redo" });
  layout->addWidget(this->Chart, 1);
  addRow(nullptr, { "invert", "fit", "reset", "logarithmic" });
  layout->addWidget(this->Panel);
  layout->addWidget(this->Message);
  this->Message->setObjectName("message");
  this->Message->setWordWrap(true);
  this->Message->setTextInteractionFlags(Qt::TextSelectableByMouse);
  this->Message->hide();
}

} // namespace tetmarch
