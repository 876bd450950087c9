// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TimeBar.h"

#include "FirstPicture/RangeText.h"
#include "Model.h"

#include <QAction>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QTimer>

namespace
{
constexpr int PauseMilliseconds = 40; // between a frame and the next step
}

namespace tetmarch
{

TimeBar::TimeBar(Model& model, QWidget* parent)
  : QToolBar(tr("Time"), parent)
  , Shown(model)
  , Slider(new QSlider(Qt::Horizontal))
  , Text(new QLabel)
{
  this->setObjectName(QStringLiteral("time"));
  this->Play = this->addAction(this->style()->standardIcon(QStyle::SP_MediaPlay), tr("Play"));
  this->Play->setObjectName(QStringLiteral("play"));
  this->Play->setCheckable(true);
  this->addWidget(this->Slider);
  this->addWidget(this->Text);
  this->Slider->setTracking(false); // a step is read when the slider is let go
  connect(this->Play, &QAction::toggled, this,
    [this](bool on)
    {
      this->Play->setIcon(
        this->style()->standardIcon(on ? QStyle::SP_MediaPause : QStyle::SP_MediaPlay));
      if (on)
      {
        this->GoOn();
      }
    });
  connect(this->Slider, &QSlider::sliderMoved, this, &TimeBar::ShowStep);
  connect(this->Slider, &QSlider::valueChanged, this, &TimeBar::Go);
  connect(&model, &Model::DataChanged, this, &TimeBar::ShowData);
  connect(&model, &Model::Rendered, this,
    [this]
    {
      if (this->IsPlaying())
      {
        QTimer::singleShot(PauseMilliseconds, this, &TimeBar::GoOn);
      }
    });
  connect(&model, &Model::Failed, this,
    [this]
    {
      this->Play->setChecked(false);
      this->ShowData();
    });
  this->setVisible(false);
}

bool TimeBar::IsPlaying() const { return this->Play->isChecked(); }

void TimeBar::ShowData()
{
  const int count = this->Shown.HasData()
                      ? static_cast<int>(this->Shown.GetScene().GetData().Data.Times.size())
                      : 0;
  this->setVisible(count > 1);
  if (count > 1)
  {
    const QSignalBlocker block(this->Slider);
    this->Slider->setRange(0, count - 1);
    const int step = this->Shown.GetScene().GetData().Data.TimeStep;
    this->Slider->setValue(step);
    this->ShowStep(step);
  }
  else
  {
    this->Play->setChecked(false);
  }
}

void TimeBar::Go(int step)
{
  this->ShowStep(step);
  this->Shown.ChooseTimeStep(step);
}

void TimeBar::GoOn()
{
  if (this->IsPlaying() && !this->Shown.GetLoader().IsBusy())
  {
    const int next = this->Shown.GetScene().GetData().Data.TimeStep + 1;
    this->Shown.ChooseTimeStep(next > this->Slider->maximum() ? 0 : next);
  }
}

void TimeBar::ShowStep(int step)
{
  const auto& times = this->Shown.GetScene().GetData().Data.Times;
  const double time = times.at(static_cast<std::size_t>(step));
  const double between = (times.back() - times.front()) / static_cast<double>(times.size());
  this->Text->setText(
    tr("  step %1 of %2, time %3  ")
      .arg(step + 1)
      .arg(times.size())
      .arg(QString::fromStdString(numberText(time, digitsWithin(time, between / 100.0)))));
}

} // namespace tetmarch
