// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the model has the loader read, and what it does with it.
#include "Model.h"

#include <algorithm>

namespace
{
using namespace tetmarch;

/// What is drawn, with its settings; a surface is there already.
LoadJob MakeJob(const ViewState& state)
{
  LoadJob job;
  job.Wanted = state.Data;
  job.Wanted.Surface.clear();
  job.GeometryTolerance = state.Settings.GeometryTolerance;
  return job;
}
} // namespace

namespace tetmarch
{

void Model::Start(Purpose purpose, const LoadJob& job)
{
  this->Why = purpose;
  this->Job = job;
  // Curved cells are cut anew for each array and tolerance. A surface needs no other mesh.
  const bool cuts = purpose != Purpose::Surface &&
                    std::max(job.GeometryTolerance, this->State.Settings.GeometryTolerance) > 0.0;
  this->Job.Shown = this->HasData() && !cuts ? this->Drawn.GetData().Data.Input : nullptr;
  Q_EMIT this->LoadingChanged(true);
  this->Reading.Start(this->Job);
}

void Model::Open(const QString& path)
{
  LoadJob job;
  job.Wanted.File = path.toStdString();
  this->Start(Purpose::NewFile, job);
}

void Model::OpenState(const ViewState& state)
{
  LoadJob job;
  job.Wanted = state.Data;
  job.ChooseFunctions = false;
  job.GeometryTolerance = state.Settings.GeometryTolerance;
  this->Wanted = state;
  this->Start(Purpose::Session, job);
}

void Model::OpenSurface(const QString& path)
{
  if (!this->HasData())
  {
    Q_EMIT this->Failed(tr("A surface is drawn together with a volume: open that first."));
    return;
  }
  LoadJob job;
  job.Wanted = this->State.Data;
  job.Wanted.Surface = path.toStdString();
  job.Read = this->Drawn.GetData().Data;
  job.ChooseFunctions = false;
  this->Start(Purpose::Surface, job);
}

void Model::ChooseArray(const std::string& name, int association, int component)
{
  LoadJob job = MakeJob(this->State);
  job.Wanted.Array = name;
  job.Wanted.Association = association;
  job.Wanted.Component = component;
  job.Read = this->Drawn.GetData().Data;
  this->Start(Purpose::Array, job);
}

void Model::ChooseTimeStep(int step)
{
  LoadJob job = MakeJob(this->State);
  job.Wanted.TimeStep = step;
  job.ChooseFunctions = false;
  this->Start(Purpose::TimeStep, job);
}

void Model::ChooseGeometryTolerance(double tolerance)
{
  LoadJob job = MakeJob(this->State);
  job.Read = this->Drawn.GetData().Data;
  job.ChooseFunctions = false;
  job.GeometryTolerance = tolerance;
  this->Start(Purpose::Tolerance, job);
}

void Model::Take(const std::shared_ptr<LoadResult>& result, const QString& failure)
{
  if (this->WaitsForFrame([this, result, failure] { this->Take(result, failure); }))
  {
    return;
  }
  if (result)
  {
    this->Show(*result);
  }
  Q_EMIT this->LoadingChanged(false);
  if (!result)
  {
    Q_EMIT this->Failed(failure);
  }
}

void Model::Show(const LoadResult& result)
{
  if (this->Why == Purpose::Surface)
  {
    this->State.Data.Surface = this->Job.Wanted.Surface;
    this->Drawn.SetSurface(result.Surface);
  }
  else if (this->Why == Purpose::Session)
  {
    ViewState read = this->Wanted;
    this->Drawn.SetData(result.Volume, result.Mapper, false, this->GetAspect(), read);
    this->Drawn.SetSurface(result.Surface);
    this->State = read;
  }
  else
  {
    this->Drawn.Capture(this->State);
    const ViewState before = this->State;
    this->State.Data.File = this->Job.Wanted.File;
    this->State.Settings.GeometryTolerance = this->Job.GeometryTolerance;
    this->Drawn.SetData(
      result.Volume, result.Mapper, this->Job.ChooseFunctions, this->GetAspect(), this->State);
    if (this->Why == Purpose::Array)
    {
      this->State.Camera = before.Camera;
      this->State.Cuts = before.Cuts;
    }
    if (this->Job.ChooseFunctions)
    {
      this->State.IsoValues = this->Drawn.MakeIsoValues(3);
    }
    if (this->Why == Purpose::NewFile)
    {
      this->State.Data.Surface.clear();
      this->Drawn.SetSurface(nullptr);
      this->State.BlendMode = 0;
      this->State.Settings.ViewMode = 0;
    }
  }
  this->Drawn.Apply(this->State);
  this->FramesOfBudget = 0;
  Q_EMIT this->DataChanged();
  Q_EMIT this->StateChanged();
  this->RequestRender();
}

} // namespace tetmarch
