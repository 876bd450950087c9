// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataPanel.h"

#include "Model.h"
#include "NumberText.h"
#include "Numbers.h"
#include "PanelParts.h"

#include "vtkDataSet.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QSignalBlocker>

namespace
{
constexpr int Isosurface = 5;
constexpr std::size_t MostIsoValues = 32;
constexpr double Denser = 100.0; // and thinner, than what was chosen
} // namespace

namespace tetmarch
{

DataPanel::DataPanel(Model& model, QWidget* parent)
  : QWidget(parent)
  , Shown(model)
  , Summary(new QLabel(tr("No data yet")))
  , Array(new QComboBox)
  , Component(new QComboBox)
  , IsoValues(new QLineEdit)
{
  auto* form = new QFormLayout(this);
  this->Summary->setWordWrap(true);
  form->addRow(this->Summary);
  this->Array->setObjectName(QStringLiteral("array"));
  this->Array->setMinimumContentsLength(10);
  this->Array->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  form->addRow(tr("Array"), this->Array);
  form->addRow(tr("Component"), this->Component);
  this->Density = MakeSlider(model, 1e-3, 1.0, ValueSlider::Logarithmic,
    [](ViewState& s) -> double& { return s.Functions.UnitDistance; });
  this->Density->setToolTip(
    tr("The length to which opacities refer: a shorter one makes the volume denser"));
  form->addRow(tr("Unit distance"), this->Density);
  this->Blend = MakeChoice(model,
    { tr("Composite"), tr("Maximum"), tr("Minimum"), tr("Average"), tr("Additive"),
      tr("Isosurfaces") },
    [](ViewState& s) -> int& { return s.BlendMode; });
  this->Blend->setObjectName(QStringLiteral("blend"));
  form->addRow(tr("Blend"), this->Blend);
  this->IsoValues->setToolTip(tr("Values of the surfaces, separated by blanks"));
  form->addRow(tr("Isovalues"), this->IsoValues);
  this->Nearest =
    MakeCheck(model, tr("Constant voxels"), [](ViewState& s) -> bool& { return s.Data.Nearest; });
  this->Nearest->setToolTip(tr("For images: each value fills its own cell"));
  form->addRow(this->Nearest);
  form->addRow(MakeCheck(model, tr("Draw cells that are not finite"),
    [](ViewState& s) -> bool& { return s.Settings.DrawNanCells; }));

  connect(this->Array, QOverload<int>::of(&QComboBox::activated), this, &DataPanel::TakeArray);
  connect(
    this->Component, QOverload<int>::of(&QComboBox::activated), this, &DataPanel::TakeComponent);
  connect(this->IsoValues, &QLineEdit::editingFinished, this, &DataPanel::TakeIsoValues);
  connect(&model, &Model::DataChanged, this, &DataPanel::ShowData);
  connect(&model, &Model::StateChanged, this, &DataPanel::ShowState);
  // A choice that failed or was cancelled leaves what is drawn.
  connect(&model, &Model::LoadingChanged, this,
    [this](bool busy)
    {
      if (!busy)
      {
        this->ShowData();
      }
    });
  this->ShowState();
}

void DataPanel::ShowData()
{
  if (!this->Shown.HasData())
  {
    return;
  }
  const ViewState& state = this->Shown.GetState();
  const Prepared& prepared = this->Shown.GetScene().GetData();
  vtkIdType cells = 0;
  vtkIdType points = 0;
  for (vtkDataSet* block : prepared.Data.Blocks)
  {
    cells += block->GetNumberOfCells();
    points += block->GetNumberOfPoints();
  }
  const QLocale locale;
  this->Summary->setText(
    tr("<b>%1</b><br>%2 cells, %3 points%4")
      .arg(QFileInfo(QString::fromStdString(state.Data.File)).fileName().toHtmlEscaped(),
        locale.toString(cells), locale.toString(points),
        prepared.Data.Blocks.size() > 1 ? tr(", %1 blocks").arg(prepared.Data.Blocks.size())
                                        : QString()));
  this->Array->clear();
  this->Component->clear();
  for (const ArrayName& array : prepared.Arrays)
  {
    this->Array->addItem(
      QString::fromStdString(array.Name) +
      (array.Association == vtkTetMarchFirstPicture::CELLS ? tr(" (cells)") : QString()));
    if (array.Name == state.Data.Array && array.Association == state.Data.Association)
    {
      this->Array->setCurrentIndex(this->Array->count() - 1);
      this->Component->addItem(array.Components > 1 ? tr("Magnitude") : tr("The only one"));
      for (int i = 0; i < array.Components && array.Components > 1; ++i)
      {
        this->Component->addItem(QString::number(i));
      }
      this->Component->setEnabled(array.Components > 1);
    }
  }
  this->Component->setCurrentIndex(this->Component->isEnabled() ? state.Data.Component + 1 : 0);
  const double chosen = prepared.Choice->GetUnitDistance();
  this->Density->SetLimits(chosen / Denser, chosen * Denser);
  this->Nearest->setEnabled(prepared.Data.Structured);
}

void DataPanel::ShowState()
{
  const ViewState& state = this->Shown.GetState();
  QStringList values;
  for (const double value : state.IsoValues)
  {
    values << QString::fromStdString(ToText(value)); // read back as the same number
  }
  if (!this->IsoValues->hasFocus())
  {
    this->IsoValues->setText(values.join(QLatin1Char(' ')));
  }
  this->IsoValues->setEnabled(state.BlendMode == Isosurface);
}

void DataPanel::TakeArray(int index)
{
  const ArrayName array = this->Shown.GetScene().GetData().Arrays.at(index);
  this->Shown.ChooseArray(array.Name, array.Association, array.Components > 1 ? -1 : 0);
}

void DataPanel::TakeComponent(int index)
{
  const DataState drawn = this->Shown.GetState().Data;
  this->Shown.ChooseArray(drawn.Array, drawn.Association, index - 1);
}

void DataPanel::TakeIsoValues()
{
  if (!this->IsoValues->isModified())
  {
    return;
  }
  this->IsoValues->setModified(false);
  const QString text = this->IsoValues->text().simplified();
  const auto values = ParseNumbers(text.toStdString(), ' ');
  if (!values || values->size() > MostIsoValues)
  {
    Q_EMIT this->Shown.Failed(
      tr("'%1' are no isovalues: give up to 32 numbers separated by blanks.").arg(text));
    return;
  }
  this->Shown.Edit([&](ViewState& s) { s.IsoValues = *values; });
}

} // namespace tetmarch
