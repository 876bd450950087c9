// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InteractorStyle.h"

#include "Model.h"

#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

namespace tetmarch
{

vtkStandardNewMacro(InteractorStyle);

void InteractorStyle::OnChar()
{
  switch (this->Interactor->GetKeyCode())
  {
    case 'x':
    case 'X':
      this->Shown->LookAlong(0);
      break;
    case 'y':
    case 'Y':
      this->Shown->LookAlong(1);
      break;
    case 'z':
    case 'Z':
      this->Shown->LookAlong(2);
      break;
    case '5':
      this->Shown->SwitchProjection();
      break;
    case 'r':
    case 'R':
      this->Shown->ResetCamera();
      break;
    case 'e': // which end the program, or switch to stereo, in VTK's own styles
    case 'E':
    case 'q':
    case 'Q':
    case '3':
      break;
    default:
      vtkInteractorStyleTrackballCamera::OnChar();
  }
}

void InteractorStyle::OnMouseWheelForward() { this->Zoom(1.1); }

void InteractorStyle::OnMouseWheelBackward() { this->Zoom(1.0 / 1.1); }

void InteractorStyle::Zoom(double factor)
{
  const int* at = this->Interactor->GetEventPosition();
  this->FindPokedRenderer(at[0], at[1]);
  if (!this->CurrentRenderer)
  {
    return;
  }
  vtkRenderWindow* window = this->Interactor->GetRenderWindow();
  window->SetDesiredUpdateRate(this->Interactor->GetDesiredUpdateRate());
  this->Dolly(factor);
  this->Shown->Settle();
}

} // namespace tetmarch
