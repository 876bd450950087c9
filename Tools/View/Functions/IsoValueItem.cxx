// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsoValueItem.h"

#include "vtkBrush.h"
#include "vtkCommand.h"
#include "vtkContext2D.h"
#include "vtkContextMouseEvent.h"
#include "vtkContextScene.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkTransform2D.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr float HandleWidth = 9.0f; // in pixels, as the others
constexpr float HandleHeight = 8.0f;
constexpr float Reach = 4.0f; // how far beside a line the mouse still takes it
constexpr float Top = 1.06f;  // a little above an opacity of 1
} // namespace

namespace tetmarch
{

vtkStandardNewMacro(IsoValueItem);

void IsoValueItem::SetIsoValues(const std::vector<double>& isoValues)
{
  if (this->IsoValues != isoValues)
  {
    this->IsoValues = isoValues;
    this->Dragged = -1;
    this->Modified();
  }
}

void IsoValueItem::SetAxis(double low, double high)
{
  this->Low = low;
  this->High = high;
}

float IsoValueItem::ToScene(double value)
{
  return static_cast<float>((value - this->Low) / (this->High - this->Low));
}

double IsoValueItem::FromScene(float x)
{
  return this->Low + static_cast<double>(x) * (this->High - this->Low);
}

bool IsoValueItem::Paint(vtkContext2D* painter)
{
  if (!this->GetVisible() || this->IsoValues.empty())
  {
    return true;
  }
  vtkMatrix3x3* const matrix = painter->GetTransform()->GetMatrix();
  this->PixelsPerUnit = static_cast<float>(matrix->GetElement(0, 0));
  const auto pixelsUp = static_cast<float>(matrix->GetElement(1, 1));
  if (!(this->PixelsPerUnit > 0.0f) || !(pixelsUp > 0.0f))
  {
    return true;
  }
  const float half = HandleWidth / 2 * this->PixelRatio / this->PixelsPerUnit;
  const float height = HandleHeight * this->PixelRatio / pixelsUp;
  painter->ApplyPen(this->Pen);
  painter->ApplyBrush(this->Brush);
  for (const double value : this->IsoValues)
  {
    const float x = this->ToScene(value);
    painter->DrawLine(x, -1.0f, x, Top);
    float triangle[] = { x - half, Top, x + half, Top, x, Top - height };
    painter->DrawPolygon(triangle, 3);
  }
  return true;
}

int IsoValueItem::FindLine(const vtkContextMouseEvent& mouse)
{
  int nearest = -1;
  float distance = Reach * this->PixelRatio;
  for (std::size_t i = 0; i < this->IsoValues.size(); ++i)
  {
    const float x = this->ToScene(this->IsoValues[i]);
    const float pixels = std::abs(mouse.GetPos().GetX() - x) * this->PixelsPerUnit;
    if (this->PixelsPerUnit > 0.0f && pixels <= distance)
    {
      nearest = static_cast<int>(i);
      distance = pixels;
    }
  }
  return nearest;
}

bool IsoValueItem::Hit(const vtkContextMouseEvent& mouse)
{
  return this->GetVisible() && this->FindLine(mouse) >= 0;
}

bool IsoValueItem::MouseButtonPressEvent(const vtkContextMouseEvent& mouse)
{
  this->Dragged =
    mouse.GetButton() == vtkContextMouseEvent::LEFT_BUTTON ? this->FindLine(mouse) : -1;
  return this->Dragged >= 0;
}

bool IsoValueItem::MouseMoveEvent(const vtkContextMouseEvent& mouse)
{
  if (this->Dragged < 0)
  {
    return false;
  }
  this->IsoValues[this->Dragged] =
    std::clamp(this->FromScene(mouse.GetPos().GetX()), this->Low, this->High);
  this->Modified();
  this->GetScene()->SetDirty(true);
  this->InvokeEvent(vtkCommand::InteractionEvent);
  return true;
}

bool IsoValueItem::MouseButtonReleaseEvent(const vtkContextMouseEvent& mouse)
{
  const bool ended = this->Dragged >= 0 && mouse.GetButton() == vtkContextMouseEvent::LEFT_BUTTON;
  if (ended)
  {
    this->Dragged = -1;
  }
  return ended;
}

} // namespace tetmarch
