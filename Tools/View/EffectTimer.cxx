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
  // Between turns the window stays alive.
  this->Next.setSingleShot(true);
  this->Next.setInterval(0);
  connect(&this->Next, &QTimer::timeout, this, &EffectTimer::TakeTurn);
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
  this->Added.clear();
  this->Once.clear();
  this->Next.stop();
  if (busy)
  {
    Q_EMIT this->Done();
  }
}

double EffectTimer::TimeFrame(const ViewState& state)
{
  this->Timed.GetScene().Apply(state);
  return this->Timed.Render();
}

void EffectTimer::TakeTurn()
{
  if (this->Waiting.empty() || this->Timed.IsDragging())
  {
    if (!this->Waiting.empty())
    {
      this->Next.start();
    }
    return;
  }
  const ViewState now = this->Timed.GetState();
  const int number = this->Waiting.front();
  const Effect& effect = GetEffects()[number];
  ViewState without = now;
  ViewState with = now;
  effect.Set(without.Effects, false);
  effect.Set(with.Effects, true);
  with.Functions.GradientOpacity =
    this->Timed.GetScene().MakeGradientOpacity(now.Effects.GradientStrength);
  this->TimeFrame(without);
  const double base = this->TimeFrame(without);
  const double first = this->TimeFrame(with);
  const double again = this->TimeFrame(with);
  this->Added.push_back(again - base);
  this->Once.push_back(std::max(first - again, 0.0));
  if (!effect.IsOn(now.Effects))
  {
    this->TimeFrame(now);
  }
  if (this->Added.size() == Turns)
  {
    Q_EMIT this->Measured(number, GetMedian(this->Added), GetMedian(this->Once));
    this->Added.clear();
    this->Once.clear();
    this->Waiting.pop_front();
    if (this->Waiting.empty())
    {
      Q_EMIT this->Done();
      return;
    }
  }
  this->Next.start();
}

} // namespace tetmarch
