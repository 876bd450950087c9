// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PanelParts.h"

#include "Model.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>

namespace tetmarch
{

ValueSlider* MakeSlider(Model& model, double least, double most, ValueSlider::Scale scale,
  std::function<double&(ViewState&)> value)
{
  auto* slider = new ValueSlider(least, most, scale);
  const auto show = [&model, slider, value]
  {
    ViewState state = model.GetState();
    slider->SetValue(value(state));
  };
  show();
  QObject::connect(&model, &Model::StateChanged, slider, show);
  QObject::connect(slider, &ValueSlider::DragBegan, &model, &Model::BeginDrag);
  QObject::connect(slider, &ValueSlider::DragEnded, &model, &Model::EndDrag);
  QObject::connect(slider, &ValueSlider::Changed, &model,
    [&model, value](double number)
    { model.Edit([&](ViewState& state) { value(state) = number; }); });
  return slider;
}

QComboBox* MakeChoice(Model& model, const QStringList& words, std::function<int&(ViewState&)> value)
{
  auto* choice = new QComboBox;
  choice->addItems(words);
  const auto show = [&model, choice, value]
  {
    ViewState state = model.GetState();
    const QSignalBlocker block(choice);
    choice->setCurrentIndex(value(state));
  };
  show();
  QObject::connect(&model, &Model::StateChanged, choice, show);
  QObject::connect(choice, QOverload<int>::of(&QComboBox::currentIndexChanged), &model,
    [&model, value](int index) { model.Edit([&](ViewState& state) { value(state) = index; }); });
  return choice;
}

QCheckBox* MakeCheck(Model& model, const QString& text, std::function<bool&(ViewState&)> value)
{
  auto* check = new QCheckBox(text);
  const auto show = [&model, check, value]
  {
    ViewState state = model.GetState();
    const QSignalBlocker block(check);
    check->setChecked(value(state));
  };
  show();
  QObject::connect(&model, &Model::StateChanged, check, show);
  QObject::connect(check, &QCheckBox::toggled, &model,
    [&model, value](bool on) { model.Edit([&](ViewState& state) { value(state) = on; }); });
  return check;
}

QLabel* MakeHeading(const QString& text)
{
  auto* label = new QLabel(text);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  label->setContentsMargins(0, 8, 0, 0);
  return label;
}

} // namespace tetmarch
