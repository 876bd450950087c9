// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// When frames are drawn, what happens meanwhile, and what is measured of them.
#include "Model.h"

#include "ProgressBar.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkCallbackCommand.h"
#include "vtkRenderWindow.h"
#include "vtkTetMarchFrameStatistics.h"
#include "vtkTetMarchSettings.h"
#include "vtkTimerLog.h"

#include <algorithm>

namespace
{
constexpr double RateAtRest = 0.0001;      // frames a second, as interactors have it
constexpr double SecondsWithoutWord = 0.5; // before a frame tells of its progress
constexpr double Ended = 2.0;
constexpr int MostFramesOfBudget = 40;
} // namespace

namespace tetmarch
{

void Model::SetWindow(vtkRenderWindow* window)
{
  this->Window = window;
  window->AddRenderer(this->Drawn.GetRenderer());
  window->SetDesiredUpdateRate(RateAtRest);
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback([](vtkObject*, unsigned long event, void* self, void*)
    { static_cast<Model*>(self)->NoteFrame(event); });
  this->Observers[0] = window->AddObserver(vtkCommand::StartEvent, command);
  this->Observers[1] = window->AddObserver(vtkCommand::EndEvent, command);
  this->Observers[2] = window->AddObserver(vtkCommand::AbortCheckEvent, command);
}

bool Model::IsAtRest() const
{
  return this->Drags == 0 && this->Window && this->Window->GetDesiredUpdateRate() < 1.0;
}

void Model::NoteFrame(unsigned long event)
{
  if (this->Drawn.GetRenderer()->GetSelector())
  {
    return; // a pick renders, too, and shows nothing
  }
  if (event == vtkCommand::StartEvent)
  {
    this->BeginFrame();
  }
  else if (event == vtkCommand::EndEvent)
  {
    this->EndFrame();
  }
  else
  {
    this->FollowFrame();
  }
}

void Model::BeginFrame()
{
  this->Drawn.GetRenderer()->ResetCameraClippingRange();
  this->FrameBegin = vtkTimerLog::GetUniversalTime();
  this->Drawing = true;
  this->Stopping = false;
  if (!this->InMeasure) // this is the frame that was asked for
  {
    this->RenderSoon.stop();
    if (this->IsAtRest())
    {
      this->SettleSoon.stop();
    }
  }
  this->Events.Begin();
}

// Frames of drags are short: their user waits for the picture.
void Model::FollowFrame()
{
  if (!this->Drawing || !this->HasData() || !this->IsAtRest())
  {
    return;
  }
  const bool asked = this->HandleEvents(tr("drawing"));
  this->Window->MakeCurrent(); // painting a panel may have changed the current context
  if (asked && !this->Whole)
  {
    this->Window->SetAbortRender(1);
    this->Window->SwapBuffersOff(); // the picture that is shown stays
  }
}

bool Model::HandleEvents(const QString& stage)
{
  if (vtkTimerLog::GetUniversalTime() - this->FrameBegin > SecondsWithoutWord)
  {
    this->Told = true;
    Q_EMIT this->DrawingProgressed(stage, this->Drawn.GetMapper().GetMapper()->GetProgress());
  }
  const bool asked = this->Events.Handle();
  return asked || this->Stopping;
}

bool Model::WaitsForFrame(const std::function<void()>& later)
{
  if (this->Drawing)
  {
    this->Stopping = true;
    this->AfterFrame.push_back(later);
  }
  return this->Drawing;
}

void Model::EndFrame()
{
  this->Window->WaitForCompletion();
  this->Stopped = this->Window->GetAbortRender() != 0;
  if (this->Stopped)
  {
    this->Window->SwapBuffersOn();
    this->Window->SetAbortRender(0);
  }
  this->Drawing = false;
  this->Events.End();
  if (!this->InMeasure)
  {
    this->EndWork();
  }
  if (this->Stopped)
  {
    this->Settle();
  }
  else if (!this->InMeasure)
  {
    this->TakeFrame();
  }
}

void Model::EndWork()
{
  if (this->Told)
  {
    this->Told = false;
    Q_EMIT this->DrawingProgressed({}, Ended);
  }
  // Not now: this is still the end of a frame.
  for (const auto& later : this->AfterFrame)
  {
    QMetaObject::invokeMethod(this, later, Qt::QueuedConnection);
  }
  this->AfterFrame.clear();
}

void Model::TakeFrame()
{
  this->LastSeconds = vtkTimerLog::GetUniversalTime() - this->FrameBegin;
  Q_EMIT this->Rendered();
  if (!this->HasData() || !this->IsAtRest())
  {
    this->MeasureSoon.stop();
    return;
  }
  // The level that keeps a budget is found by drawing frames.
  if (this->State.Settings.FrameTimeBudget > 0.0 && this->FramesOfBudget < MostFramesOfBudget)
  {
    ++this->FramesOfBudget;
    this->RequestRender();
  }
  else if (this->Measuring)
  {
    this->MeasureSoon.start();
  }
}

double Model::Render()
{
  if (this->Window && !this->WaitsForFrame([this] { this->Settle(); }))
  {
    this->SettleSoon.stop();
    this->Window->SetDesiredUpdateRate(RateAtRest);
    this->Window->Render();
  }
  return this->LastSeconds;
}

void Model::RenderWhole()
{
  this->DrawWhole([this] { this->Render(); });
}

void Model::DrawWhole(const std::function<void()>& draw)
{
  this->Whole = true;
  draw();
  this->Whole = false;
}

void Model::CancelFrames()
{
  if (!this->WaitsForFrame([this] { this->CancelFrames(); }))
  {
    this->RenderSoon.stop();
    this->SettleSoon.stop();
    this->MeasureSoon.stop();
  }
}

void Model::Measure()
{
  if (!this->HasData() || !this->Window || !this->IsAtRest() || this->Drawing)
  {
    return;
  }
  vtkTetMarchSettings* settings = this->Drawn.GetMapper().GetSettings();
  this->InMeasure = true;
  settings->CollectDiagnosticsOn();
  this->Window->Render();
  if (!this->Stopped)
  {
    Q_EMIT this->Measured();
  }
  settings->CollectDiagnosticsOff();
  this->InMeasure = false;
  this->EndWork();
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
  if (!this->HasData() || !this->Window || this->Drawing)
  {
    return false;
  }
  AnyMapper& mapper = this->Drawn.GetMapper();
  this->InMeasure = true;
  this->Window->SetDesiredUpdateRate(RateAtRest);
  mapper.GetSettings()->CollectDiagnosticsOn();
  this->Window->Render();
  bool compared = false;
  if (!this->Stopped)
  {
    this->Drawing = true;
    this->Stopping = false;
    this->Events.Begin();
    const ProgressBar following("comparing", mapper.GetMapper(),
      [this](const std::string& stage, double)
      { return !this->HandleEvents(QString::fromStdString(stage)); });
    compared = mapper.CompareWithGroundTruth(this->Drawn.GetVolume());
    this->Stopped = following.IsStopped();
    this->Drawing = false;
    this->Events.End();
  }
  if (!this->Stopped)
  {
    Q_EMIT this->Measured();
  }
  mapper.GetSettings()->CollectDiagnosticsOff();
  this->InMeasure = false;
  this->EndWork();
  return compared;
}

} // namespace tetmarch
