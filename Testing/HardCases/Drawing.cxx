// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing.h"

#include "PictureCheck.h"
#include "WebPages.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTetMarchVolumeMapper.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGridVolumeRayCastMapper.h"
#include "vtkUnstructuredGridVolumeZSweepMapper.h"
#include "vtkVolume.h"

#include <stdexcept>

namespace tetmarch::testing
{
namespace
{
vtkSmartPointer<vtkUnstructuredGridVolumeMapper> makeMapper(const std::string& name)
{
  if (name == "tetmarch")
  {
    return vtkSmartPointer<vtkTetMarchVolumeMapper>::New();
  }
  if (name == "projected")
  {
    return vtkSmartPointer<vtkProjectedTetrahedraMapper>::New();
  }
  if (name == "bunyk")
  {
    // At full resolution, whatever the time.
    auto mapper = vtkSmartPointer<vtkUnstructuredGridVolumeRayCastMapper>::New();
    mapper->SetAutoAdjustSampleDistances(0);
    mapper->SetImageSampleDistance(1.0f);
    return mapper;
  }
  if (name == "zsweep")
  {
    auto mapper = vtkSmartPointer<vtkUnstructuredGridVolumeZSweepMapper>::New();
    mapper->SetAutoAdjustSampleDistances(0);
    mapper->SetImageSampleDistance(1.0f);
    return mapper;
  }
  throw std::invalid_argument("there is no mapper named " + name);
}

void remember(vtkObject*, unsigned long, void* messages, void* text)
{
  static_cast<std::vector<std::string>*>(messages)->emplace_back(
    text ? static_cast<const char*>(text) : "");
}

Image framePicture(vtkRenderWindow* window)
{
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> rgba;
  window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, rgba);
  return Image::fromBytes(size[0], size[1], rgba->GetPointer(0));
}
} // namespace

const std::vector<std::string>& mapperNames()
{
  static const std::vector<std::string> names = { "tetmarch", "projected", "bunyk", "zsweep" };
  return names;
}

Drawn draw(const HardCase& hard, const HardView& view, const std::string& mapperName,
  vtkRenderWindow* window)
{
  const Grid grid = hard.Make();
  const auto mapper = makeMapper(mapperName);
  mapper->SetInputData(grid);
  mapper->SetScalarMode(
    hard.CellScalars ? VTK_SCALAR_MODE_USE_CELL_DATA : VTK_SCALAR_MODE_USE_POINT_DATA);
  Drawn drawn;
  vtkNew<vtkCallbackCommand> listen;
  listen->SetCallback(remember);
  listen->SetClientData(&drawn.Messages);
  mapper->AddObserver(vtkCommand::ErrorEvent, listen);
  mapper->AddObserver(vtkCommand::WarningEvent, listen);

  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  setUpHardCase(hard, view, grid, renderer, volume);
  renderer->AddVolume(volume);
  window->AddRenderer(renderer);
  auto* ours = vtkTetMarchVolumeMapper::SafeDownCast(mapper);
  if (ours)
  {
    ours->CollectDiagnosticsOn();
  }
  window->Render();
  if (ours)
  {
    vtkNew<vtkFloatArray> pixels;
    ours->GetDiagnosticPixels(pixels);
    const int* size = renderer->GetSize();
    drawn.Picture = pixels->GetNumberOfTuples() > 0
                      ? Image::fromFloats(size[0], size[1], pixels->GetPointer(0))
                      : Image(size[0], size[1]);
    drawn.Counters = { ours->GetNumberOfRays(), ours->GetNumberOfCrossedCells(),
      ours->GetNumberOfLookups(), ours->GetNumberOfRefusedEntries(), ours->GetNumberOfLostRays(),
      ours->GetNumberOfGuardHits() };
    keepWebPage(window, drawn.Picture, hard.Name + "--" + view.Name);
  }
  else
  {
    drawn.Picture = framePicture(window);
  }
  mapper->RemoveObserver(listen);
  window->RemoveRenderer(renderer);
  return drawn;
}
} // namespace tetmarch::testing
