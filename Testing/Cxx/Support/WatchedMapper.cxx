// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WatchedMapper.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <gtest/gtest.h>
#include <map>
#include <string>
#include <vector>

namespace tetmarch::testing
{
namespace
{
using State = std::map<std::string, std::vector<double>>;

struct Parameter
{
  const char* Name;
  GLenum Key;
  int Count;
};
#define PARAMETER(key, count)                                                                      \
  {                                                                                                \
#key, key, count                                                                               \
  }

const Parameter Parameters[] = { PARAMETER(GL_BLEND, 1), PARAMETER(GL_DEPTH_TEST, 1),
  PARAMETER(GL_CULL_FACE, 1), PARAMETER(GL_SCISSOR_TEST, 1), PARAMETER(GL_STENCIL_TEST, 1),
  PARAMETER(GL_MULTISAMPLE, 1), PARAMETER(GL_POLYGON_OFFSET_FILL, 1),
  PARAMETER(GL_DEPTH_WRITEMASK, 1), PARAMETER(GL_COLOR_WRITEMASK, 4), PARAMETER(GL_DEPTH_FUNC, 1),
  PARAMETER(GL_BLEND_SRC_RGB, 1), PARAMETER(GL_BLEND_DST_RGB, 1), PARAMETER(GL_BLEND_SRC_ALPHA, 1),
  PARAMETER(GL_BLEND_DST_ALPHA, 1), PARAMETER(GL_BLEND_EQUATION_RGB, 1),
  PARAMETER(GL_BLEND_EQUATION_ALPHA, 1), PARAMETER(GL_CULL_FACE_MODE, 1),
  PARAMETER(GL_FRONT_FACE, 1), PARAMETER(GL_VIEWPORT, 4), PARAMETER(GL_SCISSOR_BOX, 4),
  PARAMETER(GL_COLOR_CLEAR_VALUE, 4), PARAMETER(GL_DEPTH_CLEAR_VALUE, 1),
  PARAMETER(GL_DEPTH_RANGE, 2), PARAMETER(GL_DRAW_FRAMEBUFFER_BINDING, 1),
  PARAMETER(GL_READ_FRAMEBUFFER_BINDING, 1), PARAMETER(GL_RENDERBUFFER_BINDING, 1),
  PARAMETER(GL_DRAW_BUFFER0, 1), PARAMETER(GL_DRAW_BUFFER1, 1), PARAMETER(GL_READ_BUFFER, 1),
  PARAMETER(GL_ACTIVE_TEXTURE, 1), PARAMETER(GL_VERTEX_ARRAY_BINDING, 1),
  PARAMETER(GL_PIXEL_PACK_BUFFER_BINDING, 1), PARAMETER(GL_PIXEL_UNPACK_BUFFER_BINDING, 1),
  PARAMETER(GL_UNIFORM_BUFFER_BINDING, 1), PARAMETER(GL_PACK_ALIGNMENT, 1),
  PARAMETER(GL_UNPACK_ALIGNMENT, 1), PARAMETER(GL_LINE_WIDTH, 1), PARAMETER(GL_POINT_SIZE, 1) };

State currentState()
{
  State state;
  for (const Parameter& parameter : Parameters)
  {
    double values[4] = {};
    glGetDoublev(parameter.Key, values);
    state[parameter.Name].assign(values, values + parameter.Count);
  }
  return state;
}

// What VTK believes that the GL's state is.
State believedState(vtkOpenGLState* records)
{
  State state;
  for (const auto& [name, key] :
    { std::pair("GL_BLEND", GL_BLEND), std::pair("GL_DEPTH_TEST", GL_DEPTH_TEST),
      std::pair("GL_CULL_FACE", GL_CULL_FACE), std::pair("GL_SCISSOR_TEST", GL_SCISSOR_TEST) })
  {
    state[name] = { records->GetEnumState(static_cast<unsigned int>(key)) ? 1.0 : 0.0 };
  }
  int ints[4] = {};
  records->GetBlendFuncState(ints);
  state["GL_BLEND_SRC_RGB"] = { double(ints[0]) };
  state["GL_BLEND_DST_RGB"] = { double(ints[1]) };
  state["GL_BLEND_SRC_ALPHA"] = { double(ints[2]) };
  state["GL_BLEND_DST_ALPHA"] = { double(ints[3]) };
  records->vtkglGetIntegerv(GL_VIEWPORT, ints);
  state["GL_VIEWPORT"].assign(ints, ints + 4);
  records->vtkglGetIntegerv(GL_SCISSOR_BOX, ints);
  state["GL_SCISSOR_BOX"].assign(ints, ints + 4);
  unsigned char bytes[4] = {};
  records->vtkglGetBooleanv(GL_DEPTH_WRITEMASK, bytes);
  state["GL_DEPTH_WRITEMASK"] = { double(bytes[0]) };
  records->vtkglGetBooleanv(GL_COLOR_WRITEMASK, bytes);
  state["GL_COLOR_WRITEMASK"].assign(bytes, bytes + 4);
  records->vtkglGetIntegerv(GL_DEPTH_FUNC, ints);
  state["GL_DEPTH_FUNC"] = { double(ints[0]) };
  unsigned int binding = 0, buffer = 0;
  records->GetCurrentDrawFramebufferState(binding, buffer);
  state["GL_DRAW_FRAMEBUFFER_BINDING"] = { double(binding) };
  return state;
}
} // namespace

vtkStandardNewMacro(WatchedMapper);

void WatchedMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << "left by others";
  const State before = currentState();
  if (this->Around)
  {
    this->Around([&] { this->Superclass::Render(renderer, volume); });
  }
  else
  {
    this->Superclass::Render(renderer, volume);
  }
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  const State after = currentState();
  for (const auto& [name, values] : before)
  {
    EXPECT_EQ(values, after.at(name)) << name;
  }
  for (const auto& [name, values] : believedState(window->GetState()))
  {
    EXPECT_EQ(values, after.at(name)) << name << " as VTK sees it";
  }
  vtkInformation* keys = volume->GetPropertyKeys();
  if (!keys || !keys->Has(vtkOpenGLRenderPass::RenderPasses())) // a pass has some of its own
  {
    window->GetState()->VerifyNoActiveTextures();
  }
  ++this->Frames;
  glGetIntegerv(GL_SAMPLES, &this->Samples);
}
} // namespace tetmarch::testing
