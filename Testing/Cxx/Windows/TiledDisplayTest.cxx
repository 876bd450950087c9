// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A picture in parts, each in a window of its own or one after the other, is the picture as a
// whole.
#include "BlendedFrame.h"
#include "ErrorWatch.h"

#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>

namespace
{
using namespace tetmarch::testing;

// Two viewports, neither of them at the origin, one above the other's edge; borders of tiles lie on
// pixels.
constexpr int Width = 120;
constexpr int Height = 90;
constexpr double Viewports[][4] = { { 0.1, 0.2, 0.55, 0.9 }, { 0.55, 0.1, 1.0, 1.0 } };

// By how much edges of opaque geometry may be rasterised otherwise, in pixels.
constexpr std::size_t MostPixels = 8;

class Tiled : public testing::Test
{
protected:
  struct Display
  {
    explicit Display(int width = Width, int height = Height)
      : Window(makeWindow(width, height))
    {
    }
    vtkSmartPointer<vtkRenderWindow> Window;
    std::vector<vtkSmartPointer<vtkRenderer>> Renderers;
    std::vector<vtkSmartPointer<vtkTetMarchVolumeMapper>> Mappers;
  };

  // A background, as nobody clears what no viewport covers. Each viewport from another side, the
  // second from inside the mesh.
  void fill(Display& display) const
  {
    vtkNew<vtkRenderer> background;
    background->SetBackground(0.5, 0.1, 0.3);
    display.Window->AddRenderer(background);
    for (int i = 0; i < 2; ++i)
    {
      display.Renderers.push_back(vtkSmartPointer<vtkRenderer>::New());
      vtkRenderer* renderer = display.Renderers.back();
      const double* v = Viewports[i];
      renderer->SetViewport(v[0], v[1], v[2], v[3]);
      renderer->SetBackground(0.2, 0.4, 0.6);
      renderer->AddActor(makePlane(0.4, 0.1, { 1.0, 0.8, 0.2 }));
      display.Mappers.push_back(vtkSmartPointer<vtkTetMarchVolumeMapper>::New());
      display.Mappers.back()->SetInputData(this->Data);
      vtkNew<vtkVolume> volume;
      volume->SetMapper(display.Mappers.back());
      setBumpyFunctions(volume->GetProperty());
      volume->GetProperty()->SetScalarOpacityUnitDistance(0.25);
      renderer->AddVolume(volume);
      display.Window->AddRenderer(renderer);
      vtkCamera* camera = renderer->GetActiveCamera();
      lookAtUnitCube(camera);
      if (i == 1)
      {
        camera->SetPosition(0.05, 0.42, 0.57);
        camera->SetFocalPoint(1.0, 0.5, 0.5);
        camera->SetClippingRange(0.01, 5.0);
      }
      if (this->Parallel)
      {
        camera->ParallelProjectionOn();
        camera->SetParallelScale(0.7);
      }
    }
  }

  Image whole(int scale = 1) const
  {
    Display display(scale * Width, scale * Height);
    this->fill(display);
    display.Window->Render();
    return framePictureOf(display.Window);
  }

  // A window of a wall of them, as programs for such walls set it up: the camera of each renderer
  // looks at what of its viewport is on this tile.
  Image tile(int columns, int rows, int column, int row) const
  {
    Display display(Width / columns, Height / rows);
    this->fill(display);
    const double tile[] = { double(column) / columns, double(row) / rows, (column + 1.0) / columns,
      (row + 1.0) / rows };
    display.Window->SetTileScale(columns, rows);
    display.Window->SetTileViewport(tile[0], tile[1], tile[2], tile[3]);
    for (int i = 0; i < 2; ++i)
    {
      this->lookAtTile(display.Renderers[i]->GetActiveCamera(), Viewports[i], tile);
    }
    const ErrorWatch first(display.Mappers[0]), second(display.Mappers[1]);
    display.Window->Render();
    EXPECT_EQ(first.Errors, std::vector<std::string>());
    EXPECT_EQ(second.Errors, std::vector<std::string>());
    return framePictureOf(display.Window);
  }

  void lookAtTile(vtkCamera* camera, const double viewport[4], const double tile[4]) const
  {
    Vec3 centre{}, share{};
    for (int k = 0; k < 2; ++k)
    {
      const double low = std::clamp(tile[k], viewport[k], viewport[k + 2]);
      const double high = std::clamp(tile[k + 2], viewport[k], viewport[k + 2]);
      share[k] = (high - low) / (viewport[k + 2] - viewport[k]);
      centre[k] = high > low ? (low + high - viewport[k] - viewport[k + 2]) / (high - low) : 0.0;
    }
    const double spread = std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
    camera->SetWindowCenter(centre[0], centre[1]);
    camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(spread * share[1])));
    camera->SetParallelScale(camera->GetParallelScale() * share[1]);
  }

  void expectTogether(int columns, int rows) const
  {
    const Image whole = this->whole();
    Image together(Width, Height);
    const int w = Width / columns, h = Height / rows;
    for (int row = 0; row < rows; ++row)
    {
      for (int column = 0; column < columns; ++column)
      {
        const Image part = this->tile(columns, rows, column, row);
        ASSERT_EQ(part.Width, w);
        for (int y = 0; y < h; ++y)
        {
          std::copy_n(part.pixel(0, y), 4 * w, together.pixel(column * w, row * h + y));
        }
      }
    }
    expectFewDiffer(together, whole);
  }

  static void expectFewDiffer(const Image& a, const Image& b)
  {
    const Difference difference = compare(a, b, {}, 1.001 / 255.0, Channels::Rgb);
    std::cout << "[ MEASURED ] " << difference.text() << '\n';
    EXPECT_LE(difference.Over, MostPixels) << difference.text();
    EXPECT_GT(compare(b, Image(b.Width, b.Height)).Rms, 0.2);
  }

  Grid Data = jitteredLattice(8, 0.15, 1, sineField());
  bool Parallel = false;
};

TEST_F(Tiled, TilesOfAWallMakeThePicture)
{
  this->expectTogether(2, 2);
  this->expectTogether(3, 1);
  this->expectTogether(1, 3);
}

TEST_F(Tiled, TilesInParallelProjection)
{
  this->Parallel = true;
  this->expectTogether(2, 3);
}

TEST_F(Tiled, AnImageOfSeveralTimesTheWindowsSize)
{
  for (const int scale : { 2, 3 })
  {
    const Image large = this->whole(scale);
    for (const bool overlapping : { false, true })
    {
      SCOPED_TRACE(scale);
      Display display;
      this->fill(display);
      const ErrorWatch first(display.Mappers[0]), second(display.Mappers[1]);
      vtkNew<vtkWindowToImageFilter> filter;
      filter->SetInput(display.Window);
      filter->SetScale(scale);
      filter->SetFixBoundary(overlapping);
      filter->SetInputBufferTypeToRGBA();
      filter->ReadFrontBufferOff();
      filter->Update();
      EXPECT_EQ(first.Errors, std::vector<std::string>());
      EXPECT_EQ(second.Errors, std::vector<std::string>());
      auto* bytes =
        vtkUnsignedCharArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetScalars());
      ASSERT_EQ(bytes->GetNumberOfTuples(), large.Width * large.Height);
      expectFewDiffer(Image::fromBytes(large.Width, large.Height, bytes->GetPointer(0)), large);
      EXPECT_EQ(display.Mappers[0]->GetMeshBuilds(), 1);
    }
  }
}
} // namespace
