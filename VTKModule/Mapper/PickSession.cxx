// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/PickSession.h"

#include "Blocks/CellOrigins.h"
#include "Volume/MarchedVolume.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkHardwareSelector.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

// A volume with levels of detail, such as ParaView's, is drawn by another vtkVolume with the same
// property and matrix.
bool drawsLike(vtkVolume* drawn, vtkVolume* asked)
{
  const auto sameMatrix = [](const vtkMatrix4x4* a, const vtkMatrix4x4* b)
  { return std::equal(a->GetData(), a->GetData() + 16, b->GetData()); };
  return drawn == asked || (drawn->GetProperty() == asked->GetProperty() &&
                             sameMatrix(drawn->GetMatrix(), asked->GetMatrix()));
}

} // namespace

Pick::Pick()
  : Position{ { vtkMath::Nan(), vtkMath::Nan(), vtkMath::Nan() } }
  , Scalar(vtkMath::Nan())
{
}

void PickSession::take(bool drawn, const std::vector<PickedPoint>& points,
  const CellOrigins& origins, vtkRenderer* renderer, vtkVolume* volume,
  const MarchedVolume& marched)
{
  this->Failed = this->Failed || !drawn;
  if (renderer->GetSelector() == this->Selector && drawsLike(volume, this->Volume) &&
      !points.empty() && points.front().Hit)
  {
    const PickedPoint& point = points.front();
    const Vector3 data = marched.frame().toData(point.Position);
    double place[4] = { data[0], data[1], data[2], 1 };
    volume->GetMatrix()->MultiplyPoint(place, place);
    Pick found;
    found.Hit = true;
    std::copy_n(place, 3, found.Position.begin());
    const ScalarRange& range = marched.range();
    const bool finite = point.Scalar < double(UndrawnScalar);
    found.Scalar = finite ? range.Low + range.width() * point.Scalar : vtkMath::Nan();
    const CellOrigin origin = origins.of(point.Cell);
    found.Cell = origin.Cell;
    found.Block = origin.Block;
    this->Found.push_back(found);
  }
}

Pick PickSession::pick(vtkAbstractVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
  int x, int y, std::string& error)
{
  vtkRenderWindow* window = renderer ? renderer->GetRenderWindow() : nullptr;
  if (!window || !volume || volume->GetMapper() != mapper)
  {
    error = std::string("Nothing can be picked: ") +
            (window ? "the volume is none that this mapper draws." : "the renderer has no window.");
    return {};
  }
  if (window->GetNeverRendered())
  {
    window->Render(); // a selector cannot read a window that has never rendered
  }
  const int* size = window->GetSize();
  const bool inside = x >= 0 && y >= 0 && x < size[0] && y < size[1];
  return inside ? this->capture(
                    renderer, volume, static_cast<unsigned int>(x), static_cast<unsigned int>(y))
                : Pick();
}

Pick PickSession::capture(vtkRenderer* renderer, vtkVolume* volume, unsigned int x, unsigned int y)
{
  const unsigned int pixel[2] = { x, y };
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(x, y, x, y);
  this->Selector = selector;
  this->Volume = volume;
  this->Failed = false;
  this->Found.clear();
  const bool captured = selector->CaptureBuffers();
  this->Selector = nullptr;
  this->Volume = nullptr;
  const vtkHardwareSelector::PixelInformation found =
    captured ? selector->GetPixelInformation(pixel) : vtkHardwareSelector::PixelInformation();
  if (!found.Valid || found.Prop != volume || this->Failed)
  {
    return {};
  }
  const auto isFound = [&](const Pick& pick)
  { return pick.Cell == found.AttributeID && pick.Block == found.CompositeID; };
  const auto pick = std::find_if(this->Found.begin(), this->Found.end(), isFound);
  return pick == this->Found.end() ? Pick() : *pick;
}

} // namespace tetmarch
