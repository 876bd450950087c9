// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ProgressBar.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkObject.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace
{
std::atomic<bool> Showing{ false };
std::atomic<bool> Hidden{ false };
std::atomic<bool> Running{ false }; // there is a bar
} // namespace

namespace tetmarch
{

std::string FormatProgress(const std::string& stage, double fraction)
{
  constexpr int width = 30;
  const double clamped = fraction >= 0.0 ? std::min(fraction, 1.0) : 0.0;
  const int filled = static_cast<int>(std::lround(clamped * width));
  return stage + " [" + std::string(filled, '#') + std::string(width - filled, ' ') + "] " +
         std::to_string(static_cast<int>(std::lround(100.0 * clamped))) + " %";
}

ProgressBar::ProgressBar(std::string stage, vtkObject* source, ProgressReport report)
  : Stage(std::move(stage))
  , Source(source)
  , Report(std::move(report))
{
  if (!this->Report && (Hidden || Running || !isatty(STDERR_FILENO)))
  {
    return;
  }
  Running = Running || !this->Report;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* self, void* fraction)
    {
      if (fraction)
      {
        static_cast<ProgressBar*>(self)->Show(*static_cast<double*>(fraction));
      }
    });
  this->Source->Register(nullptr);
  this->Tag = source->AddObserver(vtkCommand::ProgressEvent, command);
  this->Show(0.0);
}

ProgressBar::~ProgressBar()
{
  if (this->Tag != 0)
  {
    this->Source->RemoveObserver(this->Tag);
    this->Source->UnRegister(nullptr);
    Running = Running && this->Report;
    Clear();
  }
}

void ProgressBar::Show(double fraction)
{
  if (this->Report)
  {
    this->Stopped = this->Stopped || !this->Report(this->Stage, fraction);
    auto* algorithm = vtkAlgorithm::SafeDownCast(this->Source);
    if (this->Stopped && algorithm)
    {
      algorithm->SetAbortExecute(1);
    }
    return;
  }
  std::fprintf(stderr, "\r%s\033[K", FormatProgress(this->Stage, fraction).c_str());
  Showing = true;
}

void ProgressBar::Clear()
{
  if (Showing)
  {
    std::fprintf(stderr, "\r\033[K");
    Showing = false;
  }
}

void ProgressBar::Hide()
{
  Clear();
  Hidden = true;
}

} // namespace tetmarch
