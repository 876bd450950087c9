// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AccuracyPanel.h"

#include "ErrorTimePlot.h"
#include "Model.h"
#include "PanelParts.h"

#include "vtkTetMarchFrameStatistics.h"
#include "vtkTetMarchSettings.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QVBoxLayout>

namespace
{
using Statistics = vtkTetMarchFrameStatistics;

void SetEnabled(QComboBox* choice, int item, bool enabled)
{
  static_cast<QStandardItemModel*>(choice->model())->item(item)->setEnabled(enabled);
}

QString Number(double number) { return QString::number(number, 'g', 3); }

/// Of the pixels whose ray met the mesh.
QString DescribeCount(Statistics* statistics, int quantity)
{
  return statistics->GetNumberOfPixels(quantity) == 0
           ? QStringLiteral("–")
           : QObject::tr("%1 mean, %2 most")
               .arg(statistics->GetMean(quantity), 0, 'f', 1)
               .arg(statistics->GetMaximum(quantity), 0, 'f', 0);
}

QString DescribeError(Statistics* statistics, int quantity)
{
  return statistics->GetNumberOfPixels(quantity) == 0
           ? QStringLiteral("–")
           : QObject::tr("%1 mean, %2 most")
               .arg(
                 Number(statistics->GetMean(quantity)), Number(statistics->GetMaximum(quantity)));
}
} // namespace

namespace tetmarch
{

AccuracyPanel::AccuracyPanel(Model& model, QWidget* parent)
  : QWidget(parent)
  , Shown(model)
{
  auto* layout = new QVBoxLayout(this);
  this->MakeSettings();
  layout->addWidget(MakeHeading(tr("Last frame")));
  this->MakeFigures();
  layout->addWidget(this->CompareButton);
  layout->addWidget(MakeHeading(tr("Error against time")));
  this->Plot = new ErrorTimePlot;
  layout->addWidget(this->Plot, 1);
  layout->addStretch(0);
  connect(&model, &Model::StateChanged, this, &AccuracyPanel::ShowState);
  connect(&model, &Model::Rendered, this, &AccuracyPanel::ShowTime);
  connect(&model, &Model::Measured, this, &AccuracyPanel::ShowFigures);
  connect(&model, &Model::DataChanged, this->Plot, &ErrorTimePlot::Clear);
  this->ShowState();
}

void AccuracyPanel::MakeSettings()
{
  auto* form = new QFormLayout;
  static_cast<QVBoxLayout*>(this->layout())->addLayout(form);
  this->Level = MakeChoice(this->Shown,
    { tr("Fast"), tr("Default"), tr("Accurate"), tr("Reference"), tr("Sampled") },
    [](ViewState& s) -> int& { return s.Settings.AccuracyLevel; });
  this->Level->setObjectName(QStringLiteral("level"));
  this->Level->setToolTip(tr("Fast guarantees no error. Default keeps the tolerance. Sampled looks "
                             "like VTK's mapper for images."));
  form->addRow(tr("Level"), this->Level);
  this->Tolerance = MakeSlider(this->Shown, 1e-5, 0.1, ValueSlider::Logarithmic,
    [](ViewState& s) -> double& { return s.Settings.ErrorTolerance; });
  this->Tolerance->setObjectName(QStringLiteral("tolerance"));
  this->Tolerance->setToolTip(tr("Maximum error of a channel of any pixel, 0 to 1"));
  form->addRow(tr("Tolerance"), this->Tolerance);
  this->Curved = new QComboBox;
  this->Curved->setObjectName(QStringLiteral("curved"));
  this->Curved->addItem(tr("Linear pieces"), 0.0);
  for (const int part : { 100, 500, 2000 })
  {
    this->Curved->addItem(tr("Within 1/%1").arg(part), 1.0 / part);
  }
  this->Curved->setToolTip(
    tr("Maximum estimated error of the shape of quadratic, Lagrange and Bezier cells, as a part of "
       "the diagonal of the data, and of the scalars within them, as a part of their range"));
  connect(this->Curved, QOverload<int>::of(&QComboBox::activated), this,
    [this] { this->Shown.ChooseGeometryTolerance(this->Curved->currentData().toDouble()); });
  form->addRow(tr("Curved cells"), this->Curved);
  // A choice that failed or was cancelled leaves what is drawn.
  connect(&this->Shown, &Model::LoadingChanged, this,
    [this](bool busy)
    {
      if (!busy)
      {
        this->ShowCurved();
      }
    });
  this->ShowCurved();
  this->Budgeted = new QCheckBox(tr("Time budget"));
  this->Budgeted->setToolTip(tr("Choose the best level whose frames take at most these seconds"));
  this->Budget = new ValueSlider(0.01, 10.0, ValueSlider::Logarithmic);
  this->Budget->SetValue(0.2);
  form->addRow(this->Budgeted, this->Budget);
  const auto takeBudget = [this]
  {
    const double seconds = this->Budgeted->isChecked() ? this->Budget->GetValue() : 0.0;
    this->Shown.Edit([&](ViewState& s) { s.Settings.FrameTimeBudget = seconds; });
  };
  connect(this->Budgeted, &QCheckBox::toggled, this, takeBudget);
  connect(this->Budget, &ValueSlider::Changed, this, takeBudget);
  this->View = MakeChoice(this->Shown,
    { tr("Picture"), tr("Error bound"), tr("Cells a ray"), tr("Lookups a ray"), tr("Illumination"),
      tr("Gradients"), tr("Boundary faces"), tr("Boundary coordinates") },
    [](ViewState& s) -> int& { return s.Settings.ViewMode; });
  this->View->setObjectName(QStringLiteral("view"));
  form->addRow(tr("Show"), this->View);
}

void AccuracyPanel::MakeFigures()
{
  auto* form = new QFormLayout;
  form->setVerticalSpacing(3);
  static_cast<QVBoxLayout*>(this->layout())->addLayout(form);
  const auto add = [&](const QString& name, QLabel*& label)
  {
    label = new QLabel(QStringLiteral("–"));
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    form->addRow(name, label);
  };
  add(tr("Time"), this->Seconds);
  add(tr("Drawn with"), this->Used);
  add(tr("Cells a ray"), this->Cells);
  add(tr("Lookups a ray"), this->Lookups);
  add(tr("Error bound"), this->Bound);
  add(tr("True error"), this->TrueError);
  this->CompareButton = new QPushButton(tr("Compare with ground truth"));
  this->CompareButton->setObjectName(QStringLiteral("compare"));
  this->CompareButton->setToolTip(
    tr("Compute the picture on the CPU in double precision. This takes seconds to minutes; any "
       "action stops it."));
  connect(this->CompareButton, &QPushButton::clicked, this, &AccuracyPanel::Compare);
}

void AccuracyPanel::showEvent(QShowEvent* event)
{
  QWidget::showEvent(event);
  this->Shown.SetMeasuring(true);
}

void AccuracyPanel::hideEvent(QHideEvent* event)
{
  QWidget::hideEvent(event);
  this->Shown.SetMeasuring(false);
}

void AccuracyPanel::ShowState()
{
  const ViewState& state = this->Shown.GetState();
  const bool hasData = this->Shown.HasData();
  const bool structured = hasData && this->Shown.GetScene().GetData().Data.Structured;
  SetEnabled(this->Level, vtkTetMarchSettings::SAMPLED, structured);
  SetEnabled(this->View, vtkTetMarchSettings::VIEW_BOUNDARY_FACES, !structured);
  SetEnabled(this->View, vtkTetMarchSettings::VIEW_BOUNDARY_COORDINATES, !structured);
  const bool budgeted = state.Settings.FrameTimeBudget > 0.0;
  const QSignalBlocker block(this->Budgeted);
  this->Budgeted->setChecked(budgeted);
  if (budgeted)
  {
    this->Budget->SetValue(state.Settings.FrameTimeBudget);
  }
  this->Level->setEnabled(!budgeted);
  this->Tolerance->setEnabled(
    !budgeted && state.Settings.AccuracyLevel == vtkTetMarchSettings::DEFAULT);
  this->CompareButton->setEnabled(hasData);
  this->TrueError->setText(QStringLiteral("–"));
}

void AccuracyPanel::ShowCurved()
{
  const double tolerance = this->Shown.GetState().Settings.GeometryTolerance;
  if (this->Curved->findData(tolerance) < 0) // of a session
  {
    this->Curved->addItem(tr("Within %1").arg(Number(tolerance)), tolerance);
  }
  this->Curved->setCurrentIndex(this->Curved->findData(tolerance));
  this->Curved->setEnabled(this->Shown.HasData() && this->Shown.GetScene().GetData().Curved);
}

void AccuracyPanel::ShowTime()
{
  this->Seconds->setText(tr("%1 s").arg(Number(this->Shown.GetLastSeconds())));
  if (this->Shown.HasData())
  {
    Statistics* statistics = this->Shown.GetScene().GetMapper().GetStatistics();
    QString used = QString::fromUtf8(statistics->GetUsedAccuracyLevelAsString());
    if (statistics->GetUsedErrorTolerance() > 0.0)
    {
      used += tr(", tolerance %1").arg(Number(statistics->GetUsedErrorTolerance()));
    }
    if (statistics->GetUsedPixelTolerance() > 0.0)
    {
      used +=
        tr(", pixels interpolated within %1").arg(Number(statistics->GetUsedPixelTolerance()));
    }
    if (statistics->GetUsedImageSampleDistance() > 1.0)
    {
      used += tr(", a ray each %1 pixels").arg(Number(statistics->GetUsedImageSampleDistance()));
    }
    this->Used->setText(used);
  }
}

QString AccuracyPanel::DescribeSetting() const { return this->Used->text(); }

void AccuracyPanel::ShowFigures()
{
  Statistics* statistics = this->Shown.GetScene().GetMapper().GetStatistics();
  this->Cells->setText(DescribeCount(statistics, Statistics::CELLS));
  this->Lookups->setText(DescribeCount(statistics, Statistics::LOOKUPS));
  this->Bound->setText(DescribeError(statistics, Statistics::ERROR_BOUND));
  this->TrueError->setText(DescribeError(statistics, Statistics::TRUE_ERROR));
  if (this->Shown.GetState().Settings.ViewMode == vtkTetMarchSettings::VIEW_PICTURE)
  {
    this->Plot->Add({ this->Shown.GetLastSeconds(), statistics->GetMaximum(Statistics::ERROR_BOUND),
      this->DescribeSetting() });
  }
}

void AccuracyPanel::Compare()
{
  if (!this->Shown.CompareWithGroundTruth() && !this->Shown.WasStopped())
  {
    Q_EMIT this->Shown.Failed(tr("The picture could not be compared with the ground truth."));
  }
}

} // namespace tetmarch
