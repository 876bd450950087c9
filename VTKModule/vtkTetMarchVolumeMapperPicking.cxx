// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a vtkTetMarchVolumeMapper does when something is picked.
#include "vtkTetMarchVolumeMapperInternals.h"

#include "vtkHardwareSelector.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>

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

//------------------------------------------------------------------------------
bool vtkTetMarchVolumeMapper::Internals::select(vtkRenderer* renderer, vtkVolume* volume,
  const tetmarch::DrawOptions& options, const tetmarch::Progress& progress)
{
  std::vector<tetmarch::PickedPoint> points;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const bool drawn =
    this->Pipeline.select(window, renderer, options, this->Blocks.origins(), progress, points);
  this->PickFailed = this->PickFailed || !drawn;
  if (renderer->GetSelector() == this->PickSelector && drawsLike(volume, this->PickVolume) &&
      !points.empty() && points.front().Hit)
  {
    const tetmarch::PickedPoint& point = points.front();
    const tetmarch::Vector3 data = this->Pipeline.source().frame().toData(point.Position);
    double place[4] = { data[0], data[1], data[2], 1 };
    volume->GetMatrix()->MultiplyPoint(place, place);
    std::copy_n(place, 3, this->PickPosition.begin());
    const tetmarch::ScalarRange& range = this->Pipeline.source().range();
    const bool finite = point.Scalar < double(tetmarch::UndrawnScalar);
    this->PickScalar = finite ? range.Low + range.width() * point.Scalar : vtkMath::Nan();
  }
  return drawn;
}

//------------------------------------------------------------------------------
bool vtkTetMarchVolumeMapper::Pick(vtkRenderer* renderer, vtkVolume* volume, int x, int y)
{
  std::fill_n(this->PickedPosition, 3, vtkMath::Nan());
  this->PickedScalar = vtkMath::Nan();
  this->PickedCellId = -1;
  this->PickedBlock = 0;
  vtkRenderWindow* window = renderer ? renderer->GetRenderWindow() : nullptr;
  if (!window || !volume || volume->GetMapper() != this)
  {
    vtkErrorMacro(
      "Nothing can be picked: " << (window ? "the volume is none that this mapper draws."
                                           : "the renderer has no window."));
    return false;
  }
  if (window->GetNeverRendered())
  {
    window->Render(); // a selector cannot read a window that has never rendered
  }
  const int* size = window->GetSize();
  if (x < 0 || y < 0 || x >= size[0] || y >= size[1])
  {
    return false;
  }
  const unsigned int pixel[2] = { static_cast<unsigned int>(x), static_cast<unsigned int>(y) };
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(pixel[0], pixel[1], pixel[0], pixel[1]);
  this->Internal->PickSelector = selector;
  this->Internal->PickVolume = volume;
  this->Internal->PickFailed = false;
  const bool captured = selector->CaptureBuffers();
  this->Internal->PickSelector = nullptr;
  this->Internal->PickVolume = nullptr;
  const vtkHardwareSelector::PixelInformation found =
    captured ? selector->GetPixelInformation(pixel) : vtkHardwareSelector::PixelInformation();
  if (!found.Valid || found.Prop != volume || this->Internal->PickFailed)
  {
    return false;
  }
  std::copy(
    this->Internal->PickPosition.begin(), this->Internal->PickPosition.end(), this->PickedPosition);
  this->PickedScalar = this->Internal->PickScalar;
  this->PickedCellId = found.AttributeID;
  this->PickedBlock = this->Internal->Blocks.grid() ? found.CompositeID : 0;
  return true;
}
