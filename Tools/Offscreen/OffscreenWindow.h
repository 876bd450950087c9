// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Render windows that need neither a display server nor a GPU, for tests and tools.
 *
 * Before VTK 9.4 a window class is compiled into VTK (X on most distributions), so the windows made
 * here own a GL context of their own. The executable that links this library serves GL through EGL
 * or through OSMesa, chosen once per process by the environment variable TETMARCH_GL:
 *
 * - egl: EGL, with a GPU if there is one, else with Mesa's software renderer
 * - osmesa: Mesa's software renderer in memory
 * - unset: egl where it gives GL 3.2, else osmesa
 *
 * VTK_DEFAULT_EGL_DEVICE_INDEX picks the EGL device by number, as it does for VTK's own window.
 *
 * From VTK 9.4 on VTK makes these windows itself; TETMARCH_GL is then translated into its variable
 * VTK_DEFAULT_OPENGL_WINDOW, unless that is set.
 */
#ifndef tetmarch_OffscreenWindow_h
#define tetmarch_OffscreenWindow_h

#include "vtkSmartPointer.h"

#include <string>

class vtkRenderWindow;

namespace tetmarch
{

/**
 * A window of the given size whose GL context exists already. On failure null, and why in error.
 */
vtkSmartPointer<vtkRenderWindow> MakeOffscreenWindow(
  int width, int height, std::string* error = nullptr);

struct GLInformation
{
  std::string Backend; // "EGL", "OSMesa" or the class name of VTK's window
  std::string Vendor;
  std::string Renderer;
  std::string Version;
};

/**
 * What serves the window's GL. The window must have been initialized or rendered.
 */
GLInformation GetGLInformation(vtkRenderWindow* window);

} // namespace tetmarch

#endif
