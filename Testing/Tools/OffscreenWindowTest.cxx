// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Run once for each backend, by TETMARCH_GL.
#include "OffscreenWindow.h"

#include "vtkActor.h"
#include "vtkConeSource.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>

namespace
{
using Pixel = std::array<int, 3>;

vtkSmartPointer<vtkRenderWindow> MakeWindow(int width, int height)
{
  std::string error;
  auto window = tetmarch::MakeOffscreenWindow(width, height, &error);
  EXPECT_TRUE(window) << error;
  return window;
}

/// A cone of a pure colour before a background of (51, 102, 153).
void AddScene(vtkRenderWindow* window, const std::array<double, 3>& color)
{
  vtkNew<vtkConeSource> cone;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cone->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.2, 0.4, 0.6);
  renderer->AddActor(actor);
  window->AddRenderer(renderer);
}

struct Image
{
  int Width = 0;
  int Height = 0;
  Pixel Centre{};
  Pixel Corner{};
};

Image Grab(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->Update();
  int dimensions[3];
  filter->GetOutput()->GetDimensions(dimensions);
  const auto at = [&filter](int x, int y)
  {
    const auto* p =
      static_cast<const unsigned char*>(filter->GetOutput()->GetScalarPointer(x, y, 0));
    return Pixel{ { p[0], p[1], p[2] } };
  };
  return { dimensions[0], dimensions[1], at(dimensions[0] / 2, dimensions[1] / 2), at(0, 0) };
}

void ExpectImage(vtkRenderWindow* window, int width, int height, const Pixel& centre)
{
  const Image image = Grab(window);
  EXPECT_EQ(image.Width, width);
  EXPECT_EQ(image.Height, height);
  EXPECT_EQ(image.Centre, centre);
  EXPECT_EQ(image.Corner, (Pixel{ { 51, 102, 153 } }));
}

// VTK's own window for EGL says that it is current whether it is or not.
bool KnowsWhetherItIsCurrent(vtkRenderWindow* window)
{
  return tetmarch::GetGLInformation(window).Backend != "vtkEGLRenderWindow";
}

const Pixel Red{ { 255, 0, 0 } };
const Pixel Green{ { 0, 255, 0 } };
} // namespace

TEST(OffscreenWindow, SaysWhatServesIt)
{
  auto window = MakeWindow(16, 16);
  ASSERT_TRUE(window);
  const auto gl = tetmarch::GetGLInformation(window);
  EXPECT_FALSE(gl.Vendor.empty());
  EXPECT_FALSE(gl.Renderer.empty());
  EXPECT_GE(std::atof(gl.Version.c_str()), 3.2) << gl.Version;
  const char* variable = std::getenv("TETMARCH_GL");
  if (variable && std::string(gl.Backend).find("vtk") != 0)
  {
    EXPECT_EQ(gl.Backend, variable == std::string("egl") ? "EGL" : "OSMesa");
  }
}

TEST(OffscreenWindow, DrawsAtAnySize)
{
  auto window = MakeWindow(200, 100);
  ASSERT_TRUE(window);
  AddScene(window, { { 1, 0, 0 } });
  window->Render();
  ExpectImage(window, 200, 100, Red);
  for (const auto& size : { std::array<int, 2>{ { 640, 480 } }, { { 33, 57 } }, { { 2000, 20 } } })
  {
    window->SetSize(size[0], size[1]);
    window->Render();
    ExpectImage(window, size[0], size[1], Red);
  }
}

TEST(OffscreenWindow, TwoLiveSideBySide)
{
  auto red = MakeWindow(200, 100);
  auto green = MakeWindow(120, 150);
  ASSERT_TRUE(red && green);
  AddScene(red, { { 1, 0, 0 } });
  AddScene(green, { { 0, 1, 0 } });
  red->Render();
  green->Render();
  red->Render();
  EXPECT_TRUE(red->IsCurrent());
  EXPECT_TRUE(!green->IsCurrent() || !KnowsWhetherItIsCurrent(green));
  ExpectImage(green, 120, 150, Green);
  ExpectImage(red, 200, 100, Red);
  green = nullptr;
  red->Render();
  ExpectImage(red, 200, 100, Red);
}

TEST(OffscreenWindow, DrawsAgainAfterFinalize)
{
  auto window = MakeWindow(64, 64);
  ASSERT_TRUE(window);
  AddScene(window, { { 0, 1, 0 } });
  window->Render();
  const bool knows = KnowsWhetherItIsCurrent(window);
  window->Finalize();
  EXPECT_TRUE(!window->IsCurrent() || !knows);
  window->Render();
  ExpectImage(window, 64, 64, Green);
}

TEST(OffscreenWindow, ManyInARow)
{
  for (int i = 0; i < 40; ++i)
  {
    auto window = MakeWindow(32, 32);
    ASSERT_TRUE(window);
    AddScene(window, { { 1, 0, 0 } });
    window->Render();
    ExpectImage(window, 32, 32, Red);
  }
}
