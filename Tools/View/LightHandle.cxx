// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LightHandle.h"

#include "vtkCallbackCommand.h"
#include "vtkMath.h"
#include "vtkProperty.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <cmath>

namespace tetmarch
{

LightHandle::LightHandle(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer,
  std::function<void(const Vector3&, bool)> moved)
  : Moved(std::move(moved))
{
  constexpr double pixels = 14.0;
  this->Ball->SetHandleSize(pixels);
  this->Ball->GetProperty()->SetColor(1.0, 0.85, 0.35);
  this->Ball->GetProperty()->LightingOff();
  this->Ball->GetSelectedProperty()->SetColor(1.0, 1.0, 0.8);
  this->Ball->GetSelectedProperty()->LightingOff();
  this->Widget->SetRepresentation(this->Ball);
  this->Widget->SetInteractor(interactor);
  this->Widget->SetDefaultRenderer(renderer);
  this->Widget->KeyPressActivationOff();

  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback([](vtkObject*, unsigned long event, void* self, void*)
    { static_cast<LightHandle*>(self)->Tell(event != vtkCommand::EndInteractionEvent); });
  this->Widget->AddObserver(vtkCommand::InteractionEvent, command);
  this->Widget->AddObserver(vtkCommand::EndInteractionEvent, command);
}

LightHandle::~LightHandle()
{
  this->Hide();
  this->Widget->RemoveAllObservers();
  this->Widget->SetInteractor(nullptr);
}

void LightHandle::SetBounds(const double bounds[6])
{
  double square = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double side = bounds[2 * i + 1] - bounds[2 * i];
    this->Centre[i] = 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
    square += side * side;
  }
  // Near enough to be in the picture of all of the data, far enough to be seen beside them.
  this->Distance = square > 0.0 ? 0.4 * std::sqrt(square) : 1.0;
}

void LightHandle::Show(const Vector3& from)
{
  if (this->Telling)
  {
    return;
  }
  Vector3 place = from;
  vtkMath::Normalize(place.data());
  for (int i = 0; i < 3; ++i)
  {
    place[i] = this->Centre[i] + this->Distance * place[i];
  }
  this->Ball->SetWorldPosition(place.data());
  this->Widget->SetEnabled(true);
}

void LightHandle::Hide() { this->Widget->SetEnabled(false); }

void LightHandle::Tell(bool dragging)
{
  Vector3 from;
  this->Ball->GetWorldPosition(from.data());
  for (int i = 0; i < 3; ++i)
  {
    from[i] -= this->Centre[i];
  }
  if (vtkMath::Normalize(from.data()) > 0.0)
  {
    this->Telling = dragging; // at the end the ball returns to its distance
    this->Moved(from, dragging);
    this->Telling = false;
  }
}

} // namespace tetmarch
