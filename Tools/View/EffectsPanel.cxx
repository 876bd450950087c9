// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EffectsPanel.h"

#include "Effect.h"
#include "EffectTimer.h"
#include "Model.h"
#include "PanelParts.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <cmath>

namespace
{
constexpr double Degrees = M_PI / 180.0;
}

namespace tetmarch
{

EffectsPanel::EffectsPanel(Model& model, QWidget* parent)
  : QWidget(parent)
  , Shown(model)
  , Timer(new EffectTimer(model, this))
{
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(this->MakeEffects());
  layout->addWidget(this->MeasureAll);
  auto* form = new QFormLayout;
  layout->addLayout(form);
  this->MakeLight(form);
  this->MakeStrengths(form);
  layout->addStretch(1);
  connect(&model, &Model::StateChanged, this, &EffectsPanel::ShowState);
  connect(this->Timer, &EffectTimer::Measured, this, &EffectsPanel::ShowCost);
  connect(this->Timer, &EffectTimer::Done, this,
    [this] { this->MeasureAll->setText(tr("Measure what each adds")); });
  this->ShowState();
}

QWidget* EffectsPanel::MakeEffects()
{
  auto* widget = new QWidget;
  auto* grid = new QGridLayout(widget);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(0, 1);
  const auto& effects = GetEffects();
  for (int i = 0; i < static_cast<int>(effects.size()); ++i)
  {
    Row row{ new QCheckBox(tr(effects[i].Name)), new QLabel };
    row.Check->setToolTip(tr(effects[i].Help));
    row.Cost->setToolTip(tr("Seconds that the effect adds to a frame, and once when it is "
                            "switched on"));
    row.Cost->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    grid->addWidget(row.Check, i, 0);
    grid->addWidget(row.Cost, i, 1);
    this->Rows.push_back(row);
    connect(row.Check, &QCheckBox::toggled, this,
      [this, i](bool on)
      {
        this->Shown.Edit([&](ViewState& s) { GetEffects()[i].Set(s, on); });
        if (on)
        {
          this->Timer->Measure(i);
        }
      });
  }
  this->MeasureAll = new QPushButton(tr("Measure what each adds"));
  this->MeasureAll->setToolTip(
    tr("Draw this view alternately without and with each effect, 12 frames per effect"));
  connect(this->MeasureAll, &QPushButton::clicked, this,
    [this]
    {
      if (this->Timer->IsBusy())
      {
        this->Timer->Stop();
        return;
      }
      for (std::size_t i = 0; i < this->Rows.size(); ++i)
      {
        this->Timer->Measure(static_cast<int>(i));
      }
      if (this->Timer->IsBusy())
      {
        this->MeasureAll->setText(tr("Stop measuring"));
      }
    });
  return widget;
}

void EffectsPanel::MakeLight(QFormLayout* form)
{
  form->addRow(MakeHeading(tr("Light")));
  form->addRow(MakeCheck(this->Shown, tr("Shines from the eye"),
    [](ViewState& s) -> bool& { return s.Effects.Headlight; }));
  this->Azimuth = new ValueSlider(-180.0, 180.0, ValueSlider::Linear);
  this->Elevation = new ValueSlider(-90.0, 90.0, ValueSlider::Linear);
  this->Azimuth->setToolTip(tr("Direction of the light around the z axis, in degrees"));
  this->Elevation->setToolTip(tr("Elevation of the light, in degrees"));
  for (ValueSlider* slider : { this->Azimuth, this->Elevation })
  {
    connect(slider, &ValueSlider::DragBegan, &this->Shown, &Model::BeginDrag);
    connect(slider, &ValueSlider::DragEnded, &this->Shown, &Model::EndDrag);
    connect(slider, &ValueSlider::Changed, this, &EffectsPanel::TurnLight);
  }
  this->Handle = new QCheckBox(tr("Show it as a ball in the picture"));
  this->Handle->setToolTip(tr("Drag the ball around the volume to turn the light"));
  connect(this->Handle, &QCheckBox::toggled, this, &EffectsPanel::HandleChanged);
  form->addRow(this->Handle);
  form->addRow(tr("Direction"), this->Azimuth);
  form->addRow(tr("Height"), this->Elevation);
  const auto add = [&](const QString& name, double most, double& (*value)(ViewState&))
  { form->addRow(name, MakeSlider(this->Shown, 0.0, most, ValueSlider::Linear, value)); };
  add(tr("Intensity"), 3.0, [](ViewState& s) -> double& { return s.Effects.Intensity; });
  add(tr("Ambient"), 1.0, [](ViewState& s) -> double& { return s.Effects.Ambient; });
  add(tr("Diffuse"), 1.0, [](ViewState& s) -> double& { return s.Effects.Diffuse; });
  add(tr("Specular"), 1.0, [](ViewState& s) -> double& { return s.Effects.Specular; });
}

void EffectsPanel::MakeStrengths(QFormLayout* form)
{
  form->addRow(MakeHeading(tr("Strength")));
  const auto add = [&](const QString& name, double least, double most, double& (*value)(ViewState&))
  { form->addRow(name, MakeSlider(this->Shown, least, most, ValueSlider::Linear, value)); };
  add(tr("Gradient opacity"), 0.0, 1.0,
    [](ViewState& s) -> double& { return s.Effects.GradientStrength; });
  add(tr("Reach of shadows"), 0.0, 1.0,
    [](ViewState& s) -> double& { return s.Settings.GlobalIlluminationReach; });
  add(tr("Occlusion radius"), 0.0, 0.5,
    [](ViewState& s) -> double& { return s.Settings.AmbientOcclusionRadius; });
  add(tr("Scattering"), 0.0, 2.0,
    [](ViewState& s) -> double& { return s.Effects.ScatteringStrength; });
}

bool EffectsPanel::IsHandleWanted() const { return this->Handle->isChecked(); }

void EffectsPanel::ShowState()
{
  const ViewState& state = this->Shown.GetState();
  const EffectState effects = state.Effects;
  for (std::size_t i = 0; i < this->Rows.size(); ++i)
  {
    const QSignalBlocker block(this->Rows[i].Check);
    this->Rows[i].Check->setChecked(GetEffects()[i].IsOn(state));
  }
  this->Azimuth->setEnabled(!effects.Headlight);
  this->Handle->setEnabled(effects.Shading && !effects.Headlight);
  this->Elevation->setEnabled(!effects.Headlight);
  const auto& from = effects.LightFrom;
  const double level = std::hypot(from[0], from[1]);
  if (level > 1e-9) // straight above, any direction will do
  {
    this->Azimuth->SetValue(std::atan2(from[1], from[0]) / Degrees);
  }
  this->Elevation->SetValue(std::atan2(from[2], level) / Degrees);
}

void EffectsPanel::TurnLight()
{
  const double azimuth = this->Azimuth->GetValue() * Degrees;
  const double elevation = this->Elevation->GetValue() * Degrees;
  this->Shown.Edit(
    [&](ViewState& s)
    {
      s.Effects.LightFrom = { { std::cos(azimuth) * std::cos(elevation),
        std::sin(azimuth) * std::cos(elevation), std::sin(elevation) } };
    });
}

void EffectsPanel::ShowCost(int effect, double added, double once)
{
  const QString sign = added < 0.0 ? QStringLiteral("−") : QStringLiteral("+");
  this->Rows[effect].Cost->setText(
    tr("%1%2 s, once %3 s").arg(sign).arg(std::abs(added), 0, 'f', 3).arg(once, 0, 'f', 2));
}

} // namespace tetmarch
