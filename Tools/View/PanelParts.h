// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What panels are made of: sliders, choices and check boxes that edit the state of a model.
 */
#ifndef tetmarch_PanelParts_h
#define tetmarch_PanelParts_h

#include "ValueSlider.h"
#include "ViewState.h"

#include <QStringList>

#include <functional>

class QCheckBox;
class QComboBox;
class QLabel;

namespace tetmarch
{
class Model;

/// Each edits one value of the state, and shows it whenever the state has changed.
ValueSlider* MakeSlider(Model& model, double least, double most, ValueSlider::Scale scale,
  std::function<double&(ViewState&)> value);
QComboBox* MakeChoice(
  Model& model, const QStringList& words, std::function<int&(ViewState&)> value);
QCheckBox* MakeCheck(Model& model, const QString& text, std::function<bool&(ViewState&)> value);

/// A heading between groups of a panel.
QLabel* MakeHeading(const QString& text);

} // namespace tetmarch

#endif
