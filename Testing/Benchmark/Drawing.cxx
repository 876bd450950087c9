// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing.h"

#include "Failure.h"
#include "Mappers.h"
#include "OffscreenWindow.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkMultiThreader.h"
#include "vtkSMPTools.h"
#include "vtkTetMarchVolumeMapper.h"
#include "vtkTimerLog.h"
#include "vtkVersion.h"
#include "vtkVolume.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace tetmarch::bench
{
namespace
{
// Oblique, so that no face of a lattice is seen edge on.
constexpr double ViewDirection[3] = { 0.5, -1.0, 0.45 };
// A frame may not live on what the one before it has sorted.
constexpr double DegreesPerFrame = 7.0;

void rememberError(vtkObject*, unsigned long, void* error, void* text)
{
  *static_cast<std::string*>(error) = text ? static_cast<const char*>(text) : "unknown error";
}

void readPixels(vtkRenderWindow* window, vtkUnsignedCharArray* pixels)
{
  const int* size = window->GetSize();
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
}
} // namespace

Drawing::Drawing(const Scene& scene, const std::string& mapper, const std::array<int, 2>& size)
  : Mapper(makeMapper(mapper))
{
  std::string error;
  this->Window = MakeOffscreenWindow(size[0], size[1], &error);
  if (!this->Window)
  {
    throw Failure("no offscreen OpenGL: " + error);
  }
  this->Mapper->SetInputData(scene.Grid);
  this->Mapper->SetScalarMode(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  this->Mapper->SelectScalarArray(scene.Array.c_str());
  vtkNew<vtkCallbackCommand> onError;
  onError->SetCallback(rememberError);
  onError->SetClientData(&this->Error);
  this->Mapper->AddObserver(vtkCommand::ErrorEvent, onError);

  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(ViewDirection);
  camera->SetViewUp(0.0, 0.0, 1.0);
  this->Renderer->ResetCamera(scene.Grid->GetBounds());
  this->Window->AddRenderer(this->Renderer);
  this->Window->Render();
  this->Window->WaitForCompletion();
  readPixels(this->Window, this->Background);

  vtkNew<vtkVolume> volume;
  volume->SetMapper(this->Mapper);
  volume->SetProperty(scene.Property);
  this->Renderer->AddVolume(volume);
}

nlohmann::json Drawing::drawFrame()
{
  const double begin = vtkTimerLog::GetUniversalTime();
  this->Window->Render();
  this->Window->WaitForCompletion();
  const double seconds = vtkTimerLog::GetUniversalTime() - begin;
  if (!this->Error.empty())
  {
    throw Failure(this->Error);
  }
  const double covered = this->coveredShare();
  if (!(covered > 0.0))
  {
    throw Failure("the picture is empty");
  }
  this->Renderer->GetActiveCamera()->Azimuth(DegreesPerFrame);
  this->Renderer->ResetCameraClippingRange();
  return { { "seconds", seconds }, { "covered", covered } };
}

/// The share of the pixels that differ from the background.
double Drawing::coveredShare()
{
  vtkNew<vtkUnsignedCharArray> pixels;
  readPixels(this->Window, pixels);
  const vtkIdType count = pixels->GetNumberOfTuples();
  vtkIdType covered = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const unsigned char* now = pixels->GetPointer(3 * i);
    covered += !std::equal(now, now + 3, this->Background->GetPointer(3 * i));
  }
  return static_cast<double>(covered) / static_cast<double>(count);
}

nlohmann::json Drawing::mapperFigures() const
{
  nlohmann::json figures = { { "class", this->Mapper->GetClassName() } };
  if (auto* ours = vtkTetMarchVolumeMapper::SafeDownCast(this->Mapper))
  {
    figures["stages"] = { { "mesh", ours->GetMeshSeconds() },
      { "scalars", ours->GetScalarsSeconds() }, { "tables", ours->GetTablesSeconds() },
      { "upload", ours->GetUploadSeconds() } };
    figures["gpu_bytes"] = ours->GetGPUMemoryBytes();
    figures["uploaded_bytes"] = ours->GetUploadedBytes();
  }
  return figures;
}

nlohmann::json Drawing::environment() const
{
  const GLInformation gl = GetGLInformation(this->Window);
  return { { "gl", { { "backend", gl.Backend }, { "vendor", gl.Vendor },
                     { "renderer", gl.Renderer }, { "version", gl.Version } } },
    { "vtk_version", vtkVersion::GetVTKVersion() },
    { "smp", { { "backend", vtkSMPTools::GetBackend() },
               { "threads", vtkSMPTools::GetEstimatedNumberOfThreads() } } },
    { "multithreader_threads", vtkMultiThreader::GetGlobalDefaultNumberOfThreads() } };
}
} // namespace tetmarch::bench
