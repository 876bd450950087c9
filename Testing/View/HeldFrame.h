// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_HeldFrame_h
#define tetmarch_HeldFrame_h

#include "Model.h"
#include "Observer.h"

#include "vtkAbstractVolumeMapper.h"

#include <QElapsedTimer>
#include <QThread>

namespace tetmarch
{

/// Holds the next frame, or comparison, between two of its parts until something has come or it is
/// stopped. Meanwhile it is asked again and again whether to go on, as one that takes long does.
class HeldFrame
{
public:
  HeldFrame(Model& model, std::function<bool()> hasCome)
    : Shown(model)
    , HasCome(std::move(hasCome))
    , Mapper(model.GetScene().GetMapper().GetMapper())
  {
  }
  HeldFrame(const HeldFrame&) = delete;
  HeldFrame& operator=(const HeldFrame&) = delete;

private:
  void Hold()
  {
    double share = this->Mapper->GetProgress();
    if (this->Held || !this->Shown.IsDrawing() || !(share > 0.0 && share < 1.0))
    {
      return;
    }
    this->Held = true;
    QElapsedTimer timer;
    timer.start();
    while (!this->HasCome() && !this->IsStopped() && timer.elapsed() < Patience)
    {
      this->Mapper->InvokeEvent(vtkCommand::ProgressEvent, &share);
      this->Shown.GetWindow()->CheckAbortStatus();
      QThread::msleep(5);
    }
  }

  bool IsStopped()
  {
    return this->Shown.GetWindow()->GetAbortRender() != 0 || this->Mapper->GetAbortExecute() != 0;
  }

  static constexpr int Patience = 300000; // milliseconds: something is wrong then

  Model& Shown;
  std::function<bool()> HasCome;
  vtkSmartPointer<vtkAbstractVolumeMapper> Mapper;
  const testing::Observer Follows{ this->Mapper, vtkCommand::ProgressEvent,
    [this] { this->Hold(); } };
  bool Held = false;
};

} // namespace tetmarch

#endif
