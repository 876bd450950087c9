// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model.h"

#include "vtkCallbackCommand.h"
#include "vtkRenderWindow.h"
#include "vtkTetMarchFrameStatistics.h"
#include "vtkTetMarchSettings.h"
#include "vtkTimerLog.h"

namespace
{
constexpr double RateOfDrags = 15.0;  // frames a second
constexpr double RateAtRest = 0.0001; // as interactors have it
constexpr int SettleMilliseconds = 250;
constexpr int MeasureMilliseconds = 400;
constexpr int MostFramesOfBudget = 40;
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
      if (this->Window)
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

void Model::SetWindow(vtkRenderWindow* window)
{
  this->Window = window;
  window->AddRenderer(this->Drawn.GetRenderer());
  window->SetDesiredUpdateRate(RateAtRest);
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback([](vtkObject*, unsigned long event, void* self, void*)
    { static_cast<Model*>(self)->NoteFrame(event == vtkCommand::StartEvent); });
  this->Observers[0] = window->AddObserver(vtkCommand::StartEvent, command);
  this->Observers[1] = window->AddObserver(vtkCommand::EndEvent, command);
}

bool Model::IsAtRest() const
{
  return this->Drags == 0 && this->Window && this->Window->GetDesiredUpdateRate() < 1.0;
}

void Model::NoteFrame(bool begins)
{
  if (begins)
  {
    this->Drawn.GetRenderer()->ResetCameraClippingRange();
    this->FrameBegin = vtkTimerLog::GetUniversalTime();
    return;
  }
  this->Window->WaitForCompletion();
  if (this->InMeasure)
  {
    return;
  }
  this->LastSeconds = vtkTimerLog::GetUniversalTime() - this->FrameBegin;
  Q_EMIT this->Rendered();
  if (!this->HasData() || !this->IsAtRest())
  {
    this->MeasureSoon.stop();
    return;
  }
  // The level that keeps a budget is found by drawing frames.
  if (this->State.Accuracy.FrameTime > 0.0 && this->FramesOfBudget < MostFramesOfBudget)
  {
    ++this->FramesOfBudget;
    this->RequestRender();
  }
  else if (this->Measuring)
  {
    this->MeasureSoon.start();
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

double Model::Render()
{
  if (this->Window)
  {
    this->SettleSoon.stop();
    this->Window->SetDesiredUpdateRate(RateAtRest);
    this->Window->Render();
  }
  return this->LastSeconds;
}

void Model::RequestRender() { this->RenderSoon.start(0); }

void Model::Settle() { this->SettleSoon.start(SettleMilliseconds); }

void Model::Measure()
{
  if (!this->HasData() || !this->Window || !this->IsAtRest())
  {
    return;
  }
  vtkTetMarchSettings* settings = this->Drawn.GetMapper().GetSettings();
  this->InMeasure = true;
  settings->CollectDiagnosticsOn();
  this->Window->Render();
  Q_EMIT this->Measured();
  settings->CollectDiagnosticsOff();
  this->InMeasure = false;
}

void Model::SetMeasuring(bool measuring)
{
  this->Measuring = measuring;
  if (measuring)
  {
    this->MeasureSoon.start();
  }
}

bool Model::CompareWithGroundTruth()
{
  if (!this->HasData() || !this->Window)
  {
    return false;
  }
  vtkTetMarchSettings* settings = this->Drawn.GetMapper().GetSettings();
  this->InMeasure = true;
  this->Window->SetDesiredUpdateRate(RateAtRest);
  settings->CollectDiagnosticsOn();
  this->Window->Render();
  const bool compared = this->Drawn.GetMapper().CompareWithGroundTruth(this->Drawn.GetVolume());
  Q_EMIT this->Measured();
  settings->CollectDiagnosticsOff();
  this->InMeasure = false;
  return compared;
}

double Model::GetAspect() const
{
  const int* size = this->Window ? this->Window->GetSize() : nullptr;
  return size && size[1] > 0 ? static_cast<double>(size[0]) / size[1] : 4.0 / 3.0;
}

} // namespace tetmarch
