// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CutWidgets.h"

#include "vtkCallbackCommand.h"
#include "vtkPlanes.h"
#include "vtkProperty.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

namespace
{
constexpr double Accent[3] = { 0.35, 0.75, 1.0 };

void SetLine(vtkProperty* property, double opacity)
{
  property->SetColor(Accent[0], Accent[1], Accent[2]);
  property->SetOpacity(opacity);
  property->LightingOff();
}
} // namespace

namespace tetmarch
{

CutWidgets::CutWidgets(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer,
  std::function<void(const CutState&, bool)> moved)
  : Moved(std::move(moved))
{
  this->Plane->SetPlaceFactor(1.0);
  this->Plane->OutlineTranslationOff();
  this->Plane->ScaleEnabledOff();
  this->Plane->DrawPlaneOff(); // it would hide what it cuts
  this->Plane->SetEdgeColor(Accent[0], Accent[1], Accent[2]);
  SetLine(this->Plane->GetOutlineProperty(), 0.25);
  SetLine(this->Plane->GetNormalProperty(), 1.0);
  this->PlaneWidget->SetRepresentation(this->Plane);
  this->Box->SetPlaceFactor(1.0);
  SetLine(this->Box->GetOutlineProperty(), 0.6);
  SetLine(this->Box->GetHandleProperty(), 1.0);
  this->BoxWidget->SetRepresentation(this->Box);
  this->BoxWidget->RotationEnabledOff();

  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback([](vtkObject*, unsigned long event, void* self, void*)
    { static_cast<CutWidgets*>(self)->Tell(event != vtkCommand::EndInteractionEvent); });
  for (vtkAbstractWidget* widget : { static_cast<vtkAbstractWidget*>(this->PlaneWidget),
         static_cast<vtkAbstractWidget*>(this->BoxWidget) })
  {
    widget->SetInteractor(interactor);
    widget->SetDefaultRenderer(renderer);
    widget->KeyPressActivationOff();
    widget->AddObserver(vtkCommand::InteractionEvent, command);
    widget->AddObserver(vtkCommand::EndInteractionEvent, command);
  }
}

CutWidgets::~CutWidgets()
{
  this->Hide();
  for (vtkAbstractWidget* widget : { static_cast<vtkAbstractWidget*>(this->PlaneWidget),
         static_cast<vtkAbstractWidget*>(this->BoxWidget) })
  {
    widget->RemoveAllObservers();
    widget->SetInteractor(nullptr);
  }
}

void CutWidgets::SetBounds(const double bounds[6])
{
  double box[6];
  std::copy(bounds, bounds + 6, box);
  this->Plane->SetWidgetBounds(box);
  this->Plane->PlaceWidget(box);
}

void CutWidgets::Show(const CutState& cuts)
{
  if (this->Telling)
  {
    return;
  }
  this->Shown = cuts;
  if (cuts.Clip)
  {
    this->Plane->SetOrigin(cuts.Origin[0], cuts.Origin[1], cuts.Origin[2]);
    this->Plane->SetNormal(cuts.Normal[0], cuts.Normal[1], cuts.Normal[2]);
  }
  if (cuts.Crop)
  {
    std::array<double, 6> box = cuts.Box;
    this->Box->PlaceWidget(box.data());
  }
  this->PlaneWidget->SetEnabled(cuts.Clip);
  this->BoxWidget->SetEnabled(cuts.Crop);
}

void CutWidgets::Hide()
{
  this->PlaneWidget->SetEnabled(false);
  this->BoxWidget->SetEnabled(false);
}

void CutWidgets::Tell(bool dragging)
{
  this->Plane->GetOrigin(this->Shown.Origin.data());
  this->Plane->GetNormal(this->Shown.Normal.data());
  if (this->Shown.Crop)
  {
    const double* box = this->Box->GetBounds();
    std::copy(box, box + 6, this->Shown.Box.begin());
  }
  this->Telling = true;
  this->Moved(this->Shown, dragging);
  this->Telling = false;
}

} // namespace tetmarch
