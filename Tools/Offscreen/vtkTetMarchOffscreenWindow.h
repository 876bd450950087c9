// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchOffscreenWindow
 * @brief   A render window that owns a GL context without a display, for VTK before 9.4
 *
 * Everything is drawn into VTK's framebuffer objects, so that any size costs nothing but those.
 * After Finalize() the next Render() starts with a new context.
 */
#ifndef vtkTetMarchOffscreenWindow_h
#define vtkTetMarchOffscreenWindow_h

#include "vtkGenericOpenGLRenderWindow.h"

#include <memory>
#include <string>

namespace tetmarch
{
class GLContext;
}

class vtkTetMarchOffscreenWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static vtkTetMarchOffscreenWindow* New();
  vtkTypeMacro(vtkTetMarchOffscreenWindow, vtkGenericOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Create the context if there is none. On failure an error is reported and rendering does
   * nothing.
   */
  void Initialize() override;
  void OpenGLInit() override { this->Initialize(); }
  void Finalize() override;
  void Render() override;

  void MakeCurrent() override;
  bool IsCurrent() override;
  int SupportsOpenGL() override;
  vtkTypeBool IsDirect() override { return 1; }

  ///@{
  /**
   * After Initialize(): "EGL", "OSMesa" or "", and why there is no context.
   */
  const char* GetBackendName() const;
  const std::string& GetError() const { return this->Error; }
  ///@}

protected:
  vtkTetMarchOffscreenWindow();
  ~vtkTetMarchOffscreenWindow() override;

  void OpenGLInitContext() override;

private:
  vtkTetMarchOffscreenWindow(const vtkTetMarchOffscreenWindow&) = delete;
  void operator=(const vtkTetMarchOffscreenWindow&) = delete;

  std::unique_ptr<tetmarch::GLContext> Context;
  std::string Error;
};

#endif
