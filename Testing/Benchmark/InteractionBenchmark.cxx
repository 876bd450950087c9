// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the CPU does for a frame, without the GL: edits of a transfer function, moves of the camera
// and frames at rest, as a table of medians. The arguments are the number of cubes along an edge of
// the lattices, and the number of frames of each row.
#include "Entries/EntryListMaker.h"
#include "Frame/FrameStages.h"
#include "Volume/TetVolume.h"

#include "Grids.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <stdexcept>

namespace
{
using namespace tetmarch;

constexpr int Width = 3840;
constexpr int Height = 2160;
constexpr std::uint64_t NoLimit = std::numeric_limits<std::uint64_t>::max();

// Cameras and their matrices need no window.
class WindowlessRenderer : public vtkRenderer
{
public:
  static WindowlessRenderer* New();
  void DeviceRender() override {}
};
vtkStandardNewMacro(WindowlessRenderer);

double secondsOf(const std::function<void()>& work)
{
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// Seconds of a frame and of its parts.
struct Parts
{
  double All = 0;
  double Tables = 0;
  double Visible = 0;
  double Lists = 0;
};

class Scene
{
public:
  explicit Scene(const testing::Grid& grid)
    : Data(grid)
  {
    this->Renderer->SetActiveCamera(this->Camera);
    this->Camera->SetFocalPoint(0.5, 0.5, 0.5);
    this->Camera->SetPosition(1.7, 1.3, 2.6);
    this->Camera->SetClippingRange(0.01, 10.0);
    this->property()->SetColor(this->Color);
    this->property()->SetScalarOpacity(this->Opacity);
    this->property()->SetScalarOpacityUnitDistance(0.25);
    this->Input.Drawn.Volume.Data = this->Data;
    this->Input.Drawn.Scalars.Array = this->Data->GetPointData()->GetScalars();
    this->Input.Renderer = this->Renderer;
    this->Input.Volume = this->Volume;
    this->showAbove(0.5, 0.0);
    this->frame();
  }

  // Scalars up to a limit are transparent.
  void showAbove(double limit, double green)
  {
    this->Color->RemoveAllPoints();
    this->Color->AddRGBPoint(0.0, 0.2, green, 1.0);
    this->Color->AddRGBPoint(1.0, 1.0, 0.3, 0.1);
    this->Opacity->RemoveAllPoints();
    this->Opacity->AddPoint(limit, 0.0);
    this->Opacity->AddPoint(1.0, 0.6);
  }
  void turn() { this->Camera->Azimuth(7.0); }
  void goInside()
  {
    this->Camera->SetPosition(0.43, 0.52, 0.47);
    this->Camera->SetFocalPoint(0.9, 0.6, 0.8);
  }
  // On a small circle, so that other tetrahedra surround the eye.
  void moveInside()
  {
    this->Camera->Yaw(7.0);
    this->Camera->SetPosition(0.43 + 0.1 * this->Camera->GetDirectionOfProjection()[0], 0.52, 0.47);
  }

  Parts frame()
  {
    const auto tables = this->Stages.tables().record();
    const auto visible = this->Tets.visibleRecord();
    Parts parts;
    parts.All = secondsOf(
      [&]
      {
        const StageResult result = this->Stages.update(this->Input, {});
        if (!result.isDone())
        {
          throw std::runtime_error("The frame was not drawn. " + result.Error);
        }
        parts.Lists = secondsOf([this] { this->listEntries(); });
      });
    parts.Tables = secondsSince(tables, this->Stages.tables().record());
    parts.Visible = secondsSince(visible, this->Tets.visibleRecord());
    return parts;
  }

  std::string sizes() const
  {
    return std::to_string(this->Tets.mesh().Tets.size()) + " tetrahedra, " +
           std::to_string(this->Tets.visiblePart().NumberOfTets) + " of them visible, with " +
           std::to_string(this->Tets.visiblePart().Faces.size()) + " faces";
  }

private:
  static double secondsSince(const StageRecord& before, const StageRecord& now)
  {
    return now.Runs == before.Runs ? 0.0 : now.Seconds;
  }

  // As TetTextures::listEntries().
  void listEntries()
  {
    const bool part = this->Tets.entersPart();
    Fingerprint version = part ? this->Tets.enteredVersion() : this->Tets.linksVersion();
    addAll(version, this->Stages.camera().NormalizedToClip);
    if (version != this->Listed)
    {
      this->Lists.make(NoLimit, this->Tets.mesh(),
        part ? this->Tets.enteredPart().Faces : this->Tets.mesh().BoundaryFaces,
        this->Stages.camera(), Width, Height, this->Tets.eyeStart());
      this->Listed = version;
    }
  }

  vtkVolumeProperty* property() { return this->Volume->GetProperty(); }

  testing::Grid Data;
  vtkNew<WindowlessRenderer> Renderer;
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkPiecewiseFunction> Opacity;
  FrameInput Input;
  TetVolume Tets;
  FrameStages Stages{ Tets };
  EntryListMaker Lists;
  Fingerprint Listed;
};

double medianOf(const std::vector<Parts>& frames, double Parts::*part)
{
  std::vector<double> seconds;
  for (const Parts& frame : frames)
  {
    seconds.push_back(frame.*part);
  }
  const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::nth_element(seconds.begin(), middle, seconds.end());
  return *middle;
}

void printRow(
  const char* name, Scene& scene, int frames, const std::function<void(int frame)>& change)
{
  std::vector<Parts> measured;
  for (int i = 0; i < frames; ++i)
  {
    change(i);
    measured.push_back(scene.frame());
  }
  std::printf("| %s |", name);
  for (double Parts::*part : { &Parts::All, &Parts::Tables, &Parts::Visible, &Parts::Lists })
  {
    std::printf(" %.3g |", 1e3 * medianOf(measured, part));
  }
  std::printf("\n");
  std::fflush(stdout);
}

void printScene(const std::string& name, const testing::Grid& grid, int frames)
{
  Scene scene(grid);
  std::printf("\n%s: %s\n\n", name.c_str(), scene.sizes().c_str());
  std::printf(
    "| frame | all, ms | tables | visible part | entry lists |\n|---|---:|---:|---:|---:|\n");
  printRow("edit: a colour", scene, frames, [&](int i) { scene.showAbove(0.5, 0.3 + 0.001 * i); });
  printRow("edit: the limit of what is visible", scene, frames,
    [&](int i) { scene.showAbove(0.5 + 0.01 * ((i + 1) % 10), 0.3); });
  printRow("camera's move", scene, frames, [&](int) { scene.turn(); });
  printRow("at rest", scene, frames, [](int) {});
  scene.showAbove(-0.5, 0.3);
  scene.frame();
  printRow("camera's move, all is visible", scene, frames, [&](int) { scene.turn(); });
  scene.goInside();
  scene.frame();
  printRow("the same inside", scene, frames, [&](int) { scene.moveInside(); });
  scene.showAbove(0.5, 0.3);
  scene.frame();
  printRow("the same inside, of what is visible", scene, frames, [&](int) { scene.moveInside(); });
}
} // namespace

int main(int argc, char* argv[])
{
  const int cubes = argc > 1 ? std::atoi(argv[1]) : 119;
  const int frames = argc > 2 ? std::atoi(argv[2]) : 15;
  const auto field = testing::sineField(2.5);
  printScene("Tetrahedra", testing::jitteredLattice(cubes, 0.15, 1, field), frames);
  printScene("Hexahedra", testing::hexLattice(cubes, 0.0, field), frames);
  return 0;
}
