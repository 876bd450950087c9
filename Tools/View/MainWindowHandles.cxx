// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the user takes hold of in the picture.
#include "MainWindow.h"

#include "CutsPanel.h"
#include "EffectsPanel.h"
#include "PictureWidget.h"

#include "vtkRenderWindowInteractor.h"

namespace tetmarch
{

void MainWindow::MakeHandles()
{
  const auto follow = [this](bool dragging)
  {
    if (dragging != this->Shown.IsDragging())
    {
      dragging ? this->Shown.BeginDrag() : this->Shown.EndDrag();
    }
  };
  vtkRenderWindowInteractor* interactor = this->Picture->interactor();
  vtkRenderer* renderer = this->Shown.GetScene().GetRenderer();
  this->Handles = std::make_unique<CutWidgets>(interactor, renderer,
    [this, follow](const CutState& cuts, bool dragging)
    {
      follow(dragging);
      this->Shown.Edit([&](ViewState& s) { s.Cuts = cuts; });
    });
  this->LightBall = std::make_unique<LightHandle>(interactor, renderer,
    [this, follow](const Vector3& from, bool dragging)
    {
      follow(dragging);
      this->Shown.Edit([&](ViewState& s) { s.Effects.LightFrom = from; });
    });
}

// One that the user holds is left as it is.
void MainWindow::ShowHandles()
{
  if (!this->Shown.HasData())
  {
    this->HideHandles();
    return;
  }
  const ViewState& state = this->Shown.GetState();
  if (this->Cuts->AreHandlesWanted())
  {
    this->Handles->Show(state.Cuts);
  }
  else
  {
    this->Handles->Hide();
  }
  if (this->Effects->IsHandleWanted() && state.Effects.Shading && !state.Effects.Headlight)
  {
    this->LightBall->Show(state.Effects.LightFrom);
  }
  else
  {
    this->LightBall->Hide();
  }
}

void MainWindow::HideHandles()
{
  this->Handles->Hide();
  this->LightBall->Hide();
}

} // namespace tetmarch
