// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The view modes: each pixel has the colour of its number.
#include "CpuReference.h"
#include "GLObjects.h"
#include "Observer.h"

#include "vtkLookupTable.h"
#include "vtkTetMarchFrameStatistics.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace
{
using namespace tetmarch::testing;
using Mapper = vtkTetMarchVolumeMapper;
using Statistics = vtkTetMarchFrameStatistics;

constexpr std::pair<int, int> Views[] = { { Mapper::VIEW_ERROR_BOUND, Statistics::ERROR_BOUND },
  { Mapper::VIEW_CELLS, Statistics::CELLS }, { Mapper::VIEW_LOOKUPS, Statistics::LOOKUPS } };

class ViewScene : public Scene
{
public:
  explicit ViewScene(vtkUnstructuredGrid* grid, int width = SceneSize, int height = SceneSize)
    : Scene(grid, width, height)
  {
    this->Mapper->CollectDiagnosticsOff();
    this->Renderer->SetBackground(0.2, 0.4, 0.6);
    this->property()->SetScalarOpacityUnitDistance(0.05);
  }
  Image view(int mode)
  {
    this->Mapper->SetViewMode(mode);
    this->Window->Render();
    return this->frame();
  }
  vtkLookupTable* table() { return this->Mapper->GetViewLookupTable(); }
};

Grid lattice() { return jitteredLattice(8, 0.15, 5, sineField()); }

// Which colour of the table each pixel has; -1 if it is none of them.
std::vector<int> entriesOf(const Image& frame, vtkLookupTable* table)
{
  const auto bytes = [](const auto* rgb)
  {
    std::array<int, 3> key{};
    for (int k = 0; k < 3; ++k)
    {
      key[k] = static_cast<int>(std::lround(255.0 * double(rgb[k])));
    }
    return key;
  };
  std::map<std::array<int, 3>, int> entries;
  for (int i = 0; i < table->GetNumberOfTableValues(); ++i)
  {
    EXPECT_TRUE(entries.emplace(bytes(table->GetTableValue(i)), i).second) << "twice: " << i;
  }
  std::vector<int> found;
  for (std::size_t i = 0; i < frame.Rgba.size(); i += 4)
  {
    const auto at = entries.find(bytes(&frame.Rgba[i]));
    found.push_back(at == entries.end() ? -1 : at->second);
  }
  return found;
}

// Those of the frame are those of the statistics, from the least to the greatest; all other pixels
// are the background's.
void expectColorsOfStatistics(ViewScene& scene, const Image& frame, int quantity)
{
  vtkLookupTable* table = scene.table();
  std::vector<int> entries = entriesOf(frame, table);
  const auto background = std::count(entries.begin(), entries.end(), -1);
  const Statistics* statistics = scene.Mapper->GetLastFrameStatistics();
  const auto count = static_cast<int>(statistics->GetNumberOfPixels(quantity));
  ASSERT_GT(count, 100);
  ASSERT_EQ(count, static_cast<int>(entries.size() - background));
  const float blue[3] = { 51 / 255.0f, 102 / 255.0f, 153 / 255.0f };
  const Mask colored = differsFrom(frame, blue, 0.5f / 255.0f);
  EXPECT_EQ(std::count(colored.begin(), colored.end(), true), count);
  std::sort(entries.begin(), entries.end());
  int off = 0;
  for (int i = 0; i < count; ++i)
  {
    const double value = statistics->GetPercentile(quantity, 100.0 * (i + 0.5) / count);
    const auto expected = static_cast<int>(table->GetIndex(value));
    const int entry = entries[static_cast<std::size_t>(background + i)];
    ASSERT_LE(std::abs(entry - expected), 1) << i << " of " << count << ", " << value;
    off += entry != expected; // between two entries, rounded to the other
  }
  EXPECT_LE(off, count / 100);
}

TEST(ViewMode, ColorsAreThoseOfTheStatistics)
{
  for (const int samples : { 0, 8 })
  {
    ViewScene scene(lattice());
    scene.Window->SetMultiSamples(samples);
    for (const auto& [mode, quantity] : Views)
    {
      const Image frame = scene.view(mode);
      SCOPED_TRACE(scene.Mapper->GetViewModeAsString());
      expectColorsOfStatistics(scene, frame, quantity);
      const double* range = scene.table()->GetTableRange();
      const double most = scene.Mapper->GetLastFrameStatistics()->GetMaximum(quantity);
      EXPECT_LE(most, range[1]);
      EXPECT_GT(most, range[1] / (mode == Mapper::VIEW_ERROR_BOUND ? 10.0 : 2.0));
    }
  }
}

TEST(ViewMode, RangeMayBeFixed)
{
  ViewScene scene(lattice());
  scene.Mapper->AutomaticViewRangeOff();
  const double ranges[][2] = { { 1e-4, 2e-3 }, { 5.0, 17.5 }, { 3.0, 1000.0 } };
  for (int i = 0; i < 3; ++i)
  {
    scene.Mapper->SetViewRange(ranges[i]);
    const Image frame = scene.view(Views[i].first);
    expectColorsOfStatistics(scene, frame, Views[i].second);
    EXPECT_EQ(scene.table()->GetTableRange()[0], ranges[i][0]);
    EXPECT_EQ(scene.table()->GetTableRange()[1], ranges[i][1]);
  }
}

TEST(ViewMode, ColorsMayBeOthers)
{
  ViewScene scene(lattice());
  scene.view(Mapper::VIEW_CELLS);
  scene.table()->SetNumberOfTableValues(7);
  for (int i = 0; i < 7; ++i)
  {
    scene.table()->SetTableValue(i, i / 7.0, 1.0, 0.0);
  }
  const Image frame = scene.view(Mapper::VIEW_CELLS);
  expectColorsOfStatistics(scene, frame, Statistics::CELLS);
}

// Where in the picture which error is, by the CPU, and in a viewport off the corner.
TEST(ViewMode, ErrorsAreWhereTheReferenceHasThem)
{
  ViewScene scene(lattice(), 240, 200);
  scene.Renderer->SetViewport(0.3, 0.15, 0.95, 0.9);
  scene.Mapper->SetErrorTolerance(1.0 / 32.0);
  const Image frame = scene.view(Mapper::VIEW_ERROR_BOUND);
  const int* size = scene.Renderer->GetSize();
  const int* origin = scene.Renderer->GetOrigin();
  const std::vector<int> entries =
    entriesOf(cropped(frame, origin[0], origin[1], size[0], size[1]), scene.table());
  const ReferencePicture reference = referenceOf(scene, {}, Precision::Float);
  const Mask inside = regionsOf(scene).Inside;
  int pixels = 0;
  int off = 0;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    if (inside[i])
    {
      ++pixels;
      const auto expected =
        static_cast<int>(scene.table()->GetIndex(double(reference.ErrorBounds[i])));
      off += std::abs(entries[i] - expected) > 1;
    }
  }
  EXPECT_GT(pixels, 1000);
  EXPECT_LE(off, pixels / 50);
}

TEST(ViewMode, RenderersSideBySideAreAsAlone)
{
  ViewScene alone(lattice(), 100, 100);
  ViewScene both(lattice(), 200, 100);
  both.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  vtkNew<vtkRenderer> left;
  left->SetViewport(0.0, 0.0, 0.5, 1.0);
  left->SetBackground(0.2, 0.4, 0.6);
  vtkNew<vtkVolume> volume;
  vtkNew<vtkTetMarchVolumeMapper> mapper;
  mapper->SetInputData(both.Data);
  volume->SetMapper(mapper);
  volume->SetProperty(both.property());
  left->AddVolume(volume);
  lookAtUnitCube(left->GetActiveCamera());
  both.Window->AddRenderer(left);
  for (const auto& right : Views)
  {
    for (const int mode : { int(Mapper::VIEW_PICTURE), int(Mapper::VIEW_LOOKUPS) })
    {
      mapper->SetViewMode(mode);
      const Image frame = both.view(right.first);
      EXPECT_EQ(cropped(frame, 0, 0, 100, 100).Rgba, alone.view(mode).Rgba);
      EXPECT_EQ(cropped(frame, 100, 0, 100, 100).Rgba, alone.view(right.first).Rgba);
    }
  }
}

TEST(ViewMode, BackToThePictureNothingIsLeft)
{
  ViewScene scene(lattice());
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
  const Image picture = scene.view(Mapper::VIEW_PICTURE);
  const auto objects = countGLObjects();
  const vtkTypeInt64 bytes = scene.Mapper->GetGPUMemoryBytes();
  for (int i = 0; i < 3; ++i)
  {
    for (const auto& [mode, quantity] : Views)
    {
      EXPECT_GT(compare(scene.view(mode), picture).Max, 0.1);
      EXPECT_GT(scene.Mapper->GetLastFrameStatistics()->GetNumberOfPixels(quantity), 0);
    }
    EXPECT_GT(countGLObjects()[0], objects[0]);
    EXPECT_GT(scene.Mapper->GetGPUMemoryBytes(), bytes);
    EXPECT_EQ(scene.view(Mapper::VIEW_PICTURE).Rgba, picture.Rgba);
    EXPECT_EQ(countGLObjects(), objects);
    EXPECT_EQ(scene.Mapper->GetGPUMemoryBytes(), bytes);
    EXPECT_EQ(scene.Mapper->GetLastFrameStatistics()->GetNumberOfPixels(Statistics::CELLS), 0);
  }
  EXPECT_EQ(scene.Mapper->GetMeshBuilds(), 1);
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  const auto released = countGLObjects();
  const Image view = scene.view(Mapper::VIEW_CELLS);
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  EXPECT_EQ(countGLObjects(), released);
  EXPECT_EQ(scene.Mapper->GetGPUMemoryBytes(), 0);
  EXPECT_EQ(scene.view(Mapper::VIEW_CELLS).Rgba, view.Rgba);
}

TEST(ViewMode, DiagnosticsChangeNothing)
{
  ViewScene scene(lattice());
  const Image view = scene.view(Mapper::VIEW_LOOKUPS);
  scene.Mapper->CollectDiagnosticsOn();
  EXPECT_EQ(scene.view(Mapper::VIEW_LOOKUPS).Rgba, view.Rgba);
  EXPECT_EQ(floatPictureOf(scene.Mapper, SceneSize, SceneSize).Width, SceneSize);
  EXPECT_GT(scene.Mapper->GetLastFrameStatistics()->GetSeconds(), 0.0);
}

TEST(ViewMode, TilesAreTheFrameAndMayBeAborted)
{
  ViewScene scene(lattice());
  scene.Mapper->SetMaxDrawTimeInSeconds(0.0);
  const Image view = scene.view(Mapper::VIEW_CELLS);
  EXPECT_EQ(scene.Mapper->GetNumberOfDraws(), 1);
  scene.Mapper->SetMaxDrawTimeInSeconds(1e-9);
  EXPECT_EQ(scene.view(Mapper::VIEW_CELLS).Rgba, view.Rgba);
  const int draws = scene.Mapper->GetNumberOfDraws();
  EXPECT_GT(draws, 10);
  {
    const Observer observer(scene.Mapper, vtkCommand::ProgressEvent,
      [&] { scene.Window->SetAbortRender(scene.Mapper->GetProgress() < 1.0); });
    scene.Window->Render();
    EXPECT_GT(scene.Mapper->GetNumberOfDraws(), 0);
    EXPECT_LT(scene.Mapper->GetNumberOfDraws(), draws);
    EXPECT_EQ(scene.Mapper->GetNumberOfRays(), 0);
  }
  EXPECT_EQ(scene.view(Mapper::VIEW_CELLS).Rgba, view.Rgba);
}

// What lies before the mesh hides it, what lies in it ends the rays.
TEST(ViewMode, OpaqueGeometryIsSeen)
{
  ViewScene scene(lattice());
  const auto plane = makePlane(1.3, 3.0, { 0.9, 0.1, 0.1 });
  scene.Renderer->AddActor(plane);
  scene.Volume->VisibilityOff();
  const Image hidden = scene.view(Mapper::VIEW_CELLS);
  scene.Volume->VisibilityOn();
  for (const auto& view : Views)
  {
    EXPECT_EQ(compare(scene.view(view.first), hidden).Max, 0.0);
    EXPECT_EQ(scene.Mapper->GetNumberOfRays(), 0);
  }
  scene.Renderer->RemoveActor(plane);
  scene.view(Mapper::VIEW_CELLS);
  const vtkTypeInt64 cells = scene.Mapper->GetNumberOfCrossedCells();
  scene.Renderer->AddActor(makePlane(0.5, 0.0, { 0.9, 0.1, 0.1 }));
  const Image frame = scene.view(Mapper::VIEW_CELLS);
  EXPECT_LT(scene.Mapper->GetNumberOfCrossedCells(), cells);
  EXPECT_GT(scene.Mapper->GetNumberOfCrossedCells(), 0);
  expectColorsOfStatistics(scene, frame, Statistics::CELLS);
}

TEST(ViewMode, CameraInside)
{
  ViewScene scene(latticeWithHole(6, 0.15, 1, sineField()));
  scene.camera()->SetPosition(0.05, 0.42, 0.57);
  scene.camera()->SetFocalPoint(1.0, 0.5, 0.5);
  scene.camera()->SetClippingRange(0.01, 5.0);
  for (const auto& [mode, quantity] : Views)
  {
    expectColorsOfStatistics(scene, scene.view(mode), quantity);
    EXPECT_EQ(scene.Mapper->GetNumberOfRays(), SceneSize * SceneSize);
  }
}

// But for the light behind the end of a ray, which thin cells have none of.
TEST(ViewMode, OfConstantCellsErrorsAreNone)
{
  ViewScene scene(lattice());
  scene.property()->SetScalarOpacityUnitDistance(10.0);
  scene.drawCellScalars();
  const Image frame = scene.view(Mapper::VIEW_ERROR_BOUND);
  EXPECT_EQ(scene.Mapper->GetLastFrameStatistics()->GetMaximum(Statistics::ERROR_BOUND), 0.0);
  const std::vector<int> entries = entriesOf(frame, scene.table());
  EXPECT_EQ(std::count(entries.begin(), entries.end(), 0), scene.Mapper->GetNumberOfRays());
}

TEST(ViewMode, OnePixel)
{
  ViewScene scene(lattice(), 1, 1);
  const Image frame = scene.view(Mapper::VIEW_CELLS);
  ASSERT_EQ(scene.Mapper->GetNumberOfRays(), 1);
  const auto cells = double(scene.Mapper->GetNumberOfCrossedCells());
  EXPECT_NEAR(entriesOf(frame, scene.table())[0], double(scene.table()->GetIndex(cells)), 1.0);
}
} // namespace
