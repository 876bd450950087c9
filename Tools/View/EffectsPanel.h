// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Effects of light, their parameters, and what each adds to a frame.
 */
#ifndef tetmarch_EffectsPanel_h
#define tetmarch_EffectsPanel_h

#include <QWidget>

#include <vector>

class QCheckBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace tetmarch
{
class EffectTimer;
class Model;
class ValueSlider;

class EffectsPanel : public QWidget
{
  Q_OBJECT

public:
  explicit EffectsPanel(Model& model, QWidget* parent = nullptr);

  EffectTimer* GetTimer() { return this->Timer; }
  QCheckBox* GetCheck(int effect) { return this->Rows[effect].Check; }
  /// Whether the light is to have a handle in the picture.
  bool IsHandleWanted() const;
  QCheckBox* GetHandle() { return this->Handle; }
  QLabel* GetCost(int effect) { return this->Rows[effect].Cost; }

Q_SIGNALS:
  void HandleChanged();

private:
  struct Row
  {
    QCheckBox* Check;
    QLabel* Cost;
  };

  QWidget* MakeEffects();
  void MakeLight(QFormLayout* form);
  void MakeStrengths(QFormLayout* form);
  void ShowState();
  void ShowCost(int effect, double added, double once);
  void TurnLight();

  Model& Shown;
  EffectTimer* Timer;
  std::vector<Row> Rows;
  QCheckBox* Handle;
  ValueSlider* Azimuth;
  ValueSlider* Elevation;
  QPushButton* MeasureAll;
};

} // namespace tetmarch

#endif
