// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchOffscreenWindow.h"

#include "GLContext.h"

#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtk_glew.h"

vtkStandardNewMacro(vtkTetMarchOffscreenWindow);

vtkTetMarchOffscreenWindow::vtkTetMarchOffscreenWindow()
{
  this->UseOffScreenBuffers = true;
  this->ShowWindow = false;
  this->MultiSamples = 0;
}

vtkTetMarchOffscreenWindow::~vtkTetMarchOffscreenWindow() { this->Finalize(); }

void vtkTetMarchOffscreenWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Backend: " << this->GetBackendName() << "\n";
  os << indent << "Error: " << this->Error << "\n";
}

void vtkTetMarchOffscreenWindow::Initialize()
{
  if (this->Initialized)
  {
    return;
  }
  this->Error.clear();
  if (!this->Context)
  {
    this->Context = tetmarch::MakeGLContext(this->Error);
  }
  if (this->Context)
  {
    this->MakeCurrent();
    this->vtkOpenGLRenderWindow::OpenGLInit(); // sets Initialized by OpenGLInitContext()
  }
  this->ReadyForRendering = this->Initialized;
  if (!this->Initialized)
  {
    this->Context.reset();
    vtkErrorMacro("No offscreen GL context: " << this->Error);
  }
}

void vtkTetMarchOffscreenWindow::OpenGLInitContext()
{
  if (this->Initialized)
  {
    return;
  }
  this->ContextCreationTime.Modified();
  // GLEW loads every function before it looks for GLX. That it finds none is no failure here.
  const GLenum result = glewInit();
  this->GlewInitValid = result == GLEW_OK || result == GLEW_ERROR_GLX_VERSION_11_ONLY ||
                        result == GLEW_ERROR_NO_GLX_DISPLAY;
  if (!this->GlewInitValid)
  {
    this->Error = std::string("GLEW can't be initialized: ") +
                  reinterpret_cast<const char*>(glewGetErrorString(result));
    return;
  }
  if (!GLEW_VERSION_3_2 || !glCreateShader || !glDrawBuffers || !glTexBuffer)
  {
    this->GlewInitValid = false;
    this->Error = "The functions of GL 3.2 can't be found";
    return;
  }
  this->Initialized = true;
  GLfloat range[2] = { 1.0f, 1.0f };
  glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range);
  this->MaximumHardwareLineWidth = range[1];
}

void vtkTetMarchOffscreenWindow::Finalize()
{
  if (!this->Context)
  {
    return;
  }
  this->MakeCurrent();
  this->ReleaseGraphicsResources(this);
  this->Context.reset();
  this->Initialized = false;
  this->ReadyForRendering = true; // the next Render() may try again
}

void vtkTetMarchOffscreenWindow::Render()
{
  this->Initialize();
  if (this->Initialized)
  {
    // The context is ours alone: no need to save and restore its state as the superclass does.
    this->vtkOpenGLRenderWindow::Render();
  }
}

void vtkTetMarchOffscreenWindow::MakeCurrent()
{
  if (this->Context && !this->Context->MakeCurrent())
  {
    vtkErrorMacro("The GL context can't be made current");
  }
}

bool vtkTetMarchOffscreenWindow::IsCurrent() { return this->Context && this->Context->IsCurrent(); }

int vtkTetMarchOffscreenWindow::SupportsOpenGL()
{
  this->Initialize();
  return this->Initialized;
}

const char* vtkTetMarchOffscreenWindow::GetBackendName() const
{
  return this->Context ? this->Context->GetBackendName() : "";
}
