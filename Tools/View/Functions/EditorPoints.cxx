// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The chosen point's numbers and colour, and presets.
#include "Failure.h"
#include "FunctionChart.h"
#include "PointPanel.h"
#include "TransferFunctionEditor.h"
#include "TransferFunctionPreset.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <QColorDialog>
#include <QFileDialog>
#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace
{
using tetmarch::ControlPoint;

/// The values between which a point can be moved: those of the points beside it.
template <typename Nodes>
std::array<double, 2> GetLimits(const Nodes& nodes, int index)
{
  const auto count = static_cast<int>(nodes.size());
  const double here = nodes[index][0];
  const double all = nodes.back()[0] - nodes.front()[0];
  const double width = all > 0.0 ? all : std::max(std::abs(here), 1.0);
  // The ends may be moved outwards, too, by as much as the functions are wide for each entry.
  return { { index > 0 ? nodes[index - 1][0] : here - width,
    index + 1 < count ? nodes[index + 1][0] : here + width } };
}
} // namespace

namespace tetmarch
{

void TransferFunctionEditor::ShowChosenPoint()
{
  const ControlPoint point = this->Chart->GetChosenPoint();
  const FunctionSnapshot state = TakeSnapshot(this->Color, this->Opacity);
  if (point.Of == ControlPoint::Kind::Opacity)
  {
    const auto limits = GetLimits(state.Opacities, point.Index);
    this->Panel->SetLimits(limits[0], limits[1]);
    this->Panel->ShowPoint(point.Of, state.Opacities[point.Index], {});
  }
  else if (point.Of == ControlPoint::Kind::Color)
  {
    const auto& node = state.Colors[point.Index];
    const auto limits = GetLimits(state.Colors, point.Index);
    this->Panel->SetLimits(limits[0], limits[1]);
    this->Panel->ShowPoint(point.Of, { { node[0], 0.0, node[4], node[5] } },
      QColor::fromRgbF(node[1], node[2], node[3]));
  }
  else
  {
    this->Panel->ShowPoint(point.Of, {}, {});
  }
}

void TransferFunctionEditor::SetNumber(int field, double number)
{
  const ControlPoint point = this->Chart->GetChosenPoint();
  const std::string kind = "number " + std::to_string(field) + " of point " +
                           std::to_string(point.Index) +
                           (point.Of == ControlPoint::Kind::Color ? " of color" : "");
  if (point.Of == ControlPoint::Kind::Opacity)
  {
    double node[4];
    this->Opacity->GetNodeValue(point.Index, node);
    node[field] = number;
    this->Edit([&] { this->Opacity->SetNodeValue(point.Index, node); }, kind);
  }
  else if (point.Of == ControlPoint::Kind::Color && field != PointPanel::Opacity)
  {
    double node[6];
    this->Color->GetNodeValue(point.Index, node);
    node[field == PointPanel::Value ? 0 : field == PointPanel::Midpoint ? 4 : 5] = number;
    this->Edit([&] { this->Color->SetNodeValue(point.Index, node); }, kind);
  }
}

void TransferFunctionEditor::SetColor(
  int index, double red, double green, double blue, const std::string& kind)
{
  if (index < this->Color->GetSize())
  {
    double node[6];
    this->Color->GetNodeValue(index, node);
    node[1] = red;
    node[2] = green;
    node[3] = blue;
    this->Edit([&] { this->Color->SetNodeValue(index, node); }, kind);
  }
}

void TransferFunctionEditor::ChooseColor()
{
  const ControlPoint point = this->Chart->GetChosenPoint();
  if (point.Of != ControlPoint::Kind::Color)
  {
    return;
  }
  std::array<double, 6> old;
  this->Color->GetNodeValue(point.Index, old.data());
  auto* const dialog = new QColorDialog(QColor::fromRgbF(old[1], old[2], old[3]), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  // What is seen while somebody looks for a colour is one step.
  const std::string kind = "color dialog " + std::to_string(++this->DialogsOpened);
  const int index = point.Index;
  QObject::connect(dialog, &QColorDialog::currentColorChanged, this,
    [this, index, kind](const QColor& color)
    { this->SetColor(index, color.redF(), color.greenF(), color.blueF(), kind); });
  QObject::connect(dialog, &QDialog::rejected, this,
    [this, index, kind, old] { this->SetColor(index, old[1], old[2], old[3], kind); });
  dialog->open();
}

void TransferFunctionEditor::AskForFile(bool save)
{
  auto* const dialog = new QFileDialog(this, save ? tr("Save a preset") : tr("Load a preset"),
    QString(), tr("Presets (*.json);;All files (*)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(save ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
  dialog->setFileMode(save ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
  dialog->setDefaultSuffix("json");
  QObject::connect(dialog, &QFileDialog::fileSelected, this,
    [this, save](const QString& path) { save ? this->SavePreset(path) : this->LoadPreset(path); });
  dialog->open();
}

std::array<double, 2> TransferFunctionEditor::GetColorRange()
{
  const double* const range = this->Color->GetRange();
  const HistogramPlot& histogram = this->Chart->GetHistogram();
  if (this->Color->GetSize() > 0 && (range[0] < range[1] || histogram.IsEmpty()))
  {
    return { { range[0], range[1] } };
  }
  return histogram.IsEmpty() ? std::array<double, 2>{ { 0.0, 1.0 } }
                             : std::array<double, 2>{ { histogram.GetLow(), histogram.GetHigh() } };
}

void TransferFunctionEditor::LoadPreset(const QString& path)
{
  try
  {
    const auto read = ReadPreset(QFile::encodeName(path).toStdString(), this->GetColorRange());
    FunctionSnapshot state =
      TakeSnapshot(read.Color, read.HasOpacityOfItsOwn ? read.Opacity.Get() : this->Opacity.Get());
    state.IsoValues = this->GetIsoValues();
    this->History.Record(state);
    this->Restore(state);
    this->ShowMessage({});
  }
  catch (const Failure& failure)
  {
    this->ShowMessage(QString::fromLocal8Bit(failure.what()));
  }
}

void TransferFunctionEditor::SavePreset(const QString& path)
{
  try
  {
    WritePreset(QFile::encodeName(path).toStdString(),
      QFileInfo(path).completeBaseName().toStdString(), this->Color, this->Opacity);
    this->ShowMessage({});
  }
  catch (const Failure& failure)
  {
    this->ShowMessage(QString::fromLocal8Bit(failure.what()));
  }
}

} // namespace tetmarch
