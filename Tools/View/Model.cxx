// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model.h"

#include "vtkRenderWindow.h"

namespace
{
constexpr double RateOfDrags = 15.0; // frames a second
constexpr int SettleMilliseconds = 250;
constexpr int MeasureMilliseconds = 400;
} // namespace

namespace tetmarch
{

Model::Model(QObject* parent)
  : QObject(parent)
{
  this->RenderSoon.setSingleShot(true);
  this->SettleSoon.setSingleShot(true);
  this->SettleSoon.setInterval(SettleMilliseconds);
  this->MeasureSoon.setSingleShot(true);
  this->MeasureSoon.setInterval(MeasureMilliseconds);
  connect(&this->RenderSoon, &QTimer::timeout, this,
    [this]
    {
      if (this->Window && !this->WaitsForFrame([this] { this->RequestRender(); }))
      {
        this->Window->Render();
      }
    });
  connect(&this->SettleSoon, &QTimer::timeout, this, [this] { this->Render(); });
  connect(&this->MeasureSoon, &QTimer::timeout, this, &Model::Measure);
  connect(&this->Reading, &Loader::Finished, this, &Model::Take);
}

Model::~Model()
{
  for (const unsigned long tag : this->Observers)
  {
    if (this->Window)
    {
      this->Window->RemoveObserver(tag);
    }
  }
}

const ViewState& Model::GetState()
{
  this->Drawn.Capture(this->State);
  if (this->Window)
  {
    const int* size = this->Window->GetSize();
    this->State.Size = { { size[0], size[1] } };
  }
  return this->State;
}

void Model::Edit(const std::function<void(ViewState&)>& change)
{
  if (this->WaitsForFrame([this, change] { this->Edit(change); }))
  {
    return;
  }
  this->Drawn.Capture(this->State);
  change(this->State);
  if (this->HasData() && this->State.Effects.GradientOpacity)
  {
    this->State.Functions.GradientOpacity =
      this->Drawn.MakeGradientOpacity(this->State.Effects.GradientStrength);
  }
  this->Drawn.Apply(this->State);
  this->FramesOfBudget = 0;
  Q_EMIT this->StateChanged();
  this->RequestRender();
}

void Model::TakeFunctions()
{
  this->Drawn.Capture(this->State);
  this->RequestRender();
}

void Model::BeginDrag()
{
  ++this->Drags;
  if (this->Window)
  {
    this->Window->SetDesiredUpdateRate(RateOfDrags);
  }
}

void Model::EndDrag()
{
  this->Drags = std::max(this->Drags - 1, 0);
  if (this->Drags == 0)
  {
    this->SettleSoon.start(0);
  }
}

void Model::ResetCamera()
{
  if (this->HasData())
  {
    this->Drawn.PlaceCamera(this->GetAspect());
    this->RequestRender();
  }
}

void Model::LookAlong(int axis)
{
  this->Drawn.LookAlong(axis);
  this->RequestRender();
}

void Model::SwitchProjection()
{
  this->Drawn.SwitchProjection();
  Q_EMIT this->StateChanged();
  this->RequestRender();
}

void Model::RequestRender() { this->RenderSoon.start(0); }

void Model::Settle() { this->SettleSoon.start(SettleMilliseconds); }

double Model::GetAspect() const
{
  const int* size = this->Window ? this->Window->GetSize() : nullptr;
  return size && size[1] > 0 ? static_cast<double>(size[0]) / size[1] : 4.0 / 3.0;
}

} // namespace tetmarch
