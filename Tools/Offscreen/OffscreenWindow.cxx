// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OffscreenWindow.h"

#include "vtkAutoInit.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
#include "vtkTetMarchOffscreenWindow.h"
#else
#include <cstdlib>
#endif

// Who makes such a window wants VTK's GL classes behind vtkRenderer, vtkPolyDataMapper and the
// rest.
VTK_MODULE_INIT(vtkRenderingOpenGL2);

namespace tetmarch
{

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)

vtkSmartPointer<vtkRenderWindow> MakeOffscreenWindow(int width, int height, std::string* error)
{
  auto window = vtkSmartPointer<vtkTetMarchOffscreenWindow>::New();
  window->SetSize(width, height);
  const bool warnings = vtkObject::GetGlobalWarningDisplay();
  vtkObject::SetGlobalWarningDisplay(warnings && !error);
  window->Initialize();
  vtkObject::SetGlobalWarningDisplay(warnings);
  if (!window->GetError().empty())
  {
    if (error)
    {
      *error = window->GetError();
    }
    return nullptr;
  }
  return window;
}

#else

vtkSmartPointer<vtkRenderWindow> MakeOffscreenWindow(int width, int height, std::string* error)
{
  const char* variable = std::getenv("TETMARCH_GL");
  const std::string backend = variable ? variable : "";
  std::string message;
  if (backend == "egl" || backend == "osmesa")
  {
    const char* name = backend == "egl" ? "vtkEGLRenderWindow" : "vtkOSOpenGLRenderWindow";
    setenv("VTK_DEFAULT_OPENGL_WINDOW", name, 0);
  }
  else if (!backend.empty())
  {
    message = "TETMARCH_GL is '" + backend + "'; it must be egl, osmesa or unset";
  }
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  if (message.empty())
  {
    window->SetOffScreenRendering(true);
    window->SetMultiSamples(0);
    window->SetSize(width, height);
    window->Initialize();
    message =
      window->SupportsOpenGL() ? "" : window->GetClassName() + std::string(" has no GL 3.2");
  }
  if (!message.empty())
  {
    if (error)
    {
      *error = message;
    }
    return nullptr;
  }
  return window;
}

#endif

GLInformation GetGLInformation(vtkRenderWindow* window)
{
  GLInformation information;
  auto* glWindow = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (!glWindow)
  {
    return information;
  }
  information.Backend = window->GetClassName();
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
  if (auto* offscreen = vtkTetMarchOffscreenWindow::SafeDownCast(window))
  {
    information.Backend = offscreen->GetBackendName();
  }
#endif
  glWindow->MakeCurrent();
  vtkOpenGLState* state = glWindow->GetState();
  information.Vendor = state->GetVendor();
  information.Renderer = state->GetRenderer();
  information.Version = state->GetVersion();
  return information;
}

} // namespace tetmarch
