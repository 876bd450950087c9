// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EffectTimer.h"

#include "Effect.h"
#include "Model.h"

#include <algorithm>

namespace
{
constexpr std::size_t Turns = 3;

double GetMedian(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}
} // namespace

namespace tetmarch
{

EffectTimer::EffectTimer(Model& model, QObject* parent)
  : QObject(parent)
  , Timed(model)
{
  // Between frames the window stays alive.
  this->Next.setSingleShot(true);
  this->Next.setInterval(0);
  connect(&this->Next, &QTimer::timeout, this, &EffectTimer::TakeFrame);
  // What was begun is of another scene.
  connect(&model, &Model::StateChanged, this, [this] { this->Turn.clear(); });
  connect(&model, &Model::DataChanged, this, &EffectTimer::Stop);
}

void EffectTimer::Measure(int effect)
{
  if (this->Timed.HasData() &&
      std::find(this->Waiting.begin(), this->Waiting.end(), effect) == this->Waiting.end())
  {
    this->Waiting.push_back(effect);
    this->Next.start();
  }
}

void EffectTimer::Stop()
{
  const bool busy = this->IsBusy();
  this->Waiting.clear();
  this->Turn.clear();
  this->Added.clear();
  this->Once.clear();
  this->Next.stop();
  if (busy)
  {
    this->ShowState();
    Q_EMIT this->Done();
  }
}

void EffectTimer::TakeFrame()
{
  if (this->Waiting.empty())
  {
    return;
  }
  this->Next.start();
  if (this->Timed.IsDrawing())
  {
    return;
  }
  if (this->Timed.IsDragging())
  {
    this->Turn.clear();
    return;
  }
  const Effect& effect = GetEffects()[this->Waiting.front()];
  ViewState state = this->Timed.GetState();
  effect.Set(state, false);
  const bool with = this->Turn.size() >= 2;
  if (with)
  {
    effect.Set(state, true);
    state.Functions.GradientOpacity =
      this->Timed.GetScene().MakeGradientOpacity(state.Effects.GradientStrength);
  }
  this->Timed.GetScene().Apply(state);
  const double seconds = this->Timed.Render();
  if (this->Timed.WasStopped())
  {
    this->Turn.clear();
    return;
  }
  this->Turn.push_back(seconds);
  if (this->Turn.size() == 4)
  {
    this->Added.push_back(this->Turn[3] - this->Turn[1]);
    this->Once.push_back(std::max(this->Turn[2] - this->Turn[3], 0.0));
    this->Turn.clear();
    if (this->Added.size() == Turns)
    {
      this->Finish();
    }
  }
}

void EffectTimer::ShowState()
{
  this->Timed.GetScene().Apply(this->Timed.GetState());
  this->Timed.RequestRender();
}

void EffectTimer::Finish()
{
  const int number = this->Waiting.front();
  this->Waiting.pop_front();
  const double added = GetMedian(this->Added);
  const double once = GetMedian(this->Once);
  this->Added.clear();
  this->Once.clear();
  Q_EMIT this->Measured(number, added, once);
  if (this->Waiting.empty())
  {
    this->Next.stop();
    this->ShowState();
    Q_EMIT this->Done();
  }
}

} // namespace tetmarch
