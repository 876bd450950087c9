// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Opaque geometry ends rays in a framebuffer of any format of depths, with any number of samples. A
// GL copies depths between equal formats alone.
#include "ErrorWatch.h"
#include "GLPointers.h"
#include "Scene.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 80;

struct DepthFormat
{
  const char* Name;
  GLenum Format;
  bool Stencil;
};

constexpr DepthFormat Formats[] = { { "16", GL_DEPTH_COMPONENT16, false },
  { "24", GL_DEPTH_COMPONENT24, false }, { "32", GL_DEPTH_COMPONENT32, false },
  { "32F", GL_DEPTH_COMPONENT32F, false }, { "24, stencil", GL_DEPTH24_STENCIL8, true },
  { "32F, stencil", GL_DEPTH32F_STENCIL8, true } };

// Draws the scene into a framebuffer of its own.
class FormatPass : public vtkRenderPass
{
public:
  static FormatPass* New();
  vtkTypeMacro(FormatPass, vtkRenderPass);

  void Render(const vtkRenderState* state) override
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetRenderWindow());
    vtkOpenGLState* gl = window->GetState();
    gl->PushFramebufferBindings();
    GLuint framebuffer = 0;
    GLuint buffers[2] = {};
    glGenFramebuffers(1, &framebuffer);
    glGenRenderbuffers(2, buffers);
    const auto make = [this](GLuint buffer, GLenum format)
    {
      glBindRenderbuffer(GL_RENDERBUFFER, buffer);
      glRenderbufferStorageMultisample(GL_RENDERBUFFER, this->Samples, format, Side, Side);
    };
    make(buffers[0], GL_RGBA8);
    make(buffers[1], this->Depth.Format);
    gl->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    const GLenum attachment =
      this->Depth.Stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[0]);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffers[1]);
    EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), GLenum(GL_FRAMEBUFFER_COMPLETE));
    this->Steps->Render(state);
    gl->PopFramebufferBindings();
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(2, buffers);
  }
  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Steps->ReleaseGraphicsResources(window);
  }

  DepthFormat Depth = Formats[0];
  int Samples = 0;

private:
  vtkNew<vtkRenderStepsPass> Steps;
};
vtkStandardNewMacro(FormatPass);

TEST(DepthFormats, OfAllKinds)
{
  Scene scene(jitteredLattice(6, 0.15, 1, sineField()), Side, Side);
  const Image whole = scene.render();
  scene.Renderer->AddActor(makePlane(0.5, 0.3, { 1.0, 1.0, 1.0 }));
  scene.Renderer->ResetCameraClippingRange();
  const Image cut = scene.render();
  ASSERT_GT(compare(cut, whole).Max, 0.1) << "the plane cuts nothing";
  const ErrorWatch watch(scene.Mapper);
  vtkNew<FormatPass> pass;
  vtkOpenGLRenderer::SafeDownCast(scene.Renderer)->SetPass(pass);
  for (const DepthFormat& format : Formats)
  {
    for (const int samples : { 0, 4 })
    {
      pass->Depth = format;
      pass->Samples = samples;
      scene.Window->Render();
      const Difference difference = compare(floatPictureOf(scene.Mapper, Side, Side), cut);
      EXPECT_EQ(watch.Errors, std::vector<std::string>()) << format.Name << ", " << samples;
      // Samples of a pixel have depths beside its middle.
      EXPECT_LE(difference.Max, samples > 0 ? 0.02 : 0.002)
        << format.Name << ", " << samples << ": " << difference.text();
    }
  }
  pass->ReleaseGraphicsResources(scene.Window);
}
} // namespace
