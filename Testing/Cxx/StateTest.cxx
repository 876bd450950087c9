// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The GL state is after a frame of the mapper as it was before, both in the GL and in VTK's
// records.
#include "Observer.h"
#include "Scene.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>
#include <map>

namespace
{
using namespace tetmarch::testing;

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

// Looks at the state around its frames.
class WatchedMapper : public vtkTetMarchVolumeMapper
{
public:
  static WatchedMapper* New();
  vtkTypeMacro(WatchedMapper, vtkTetMarchVolumeMapper);

  void Render(vtkRenderer* renderer, vtkVolume* volume) override
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    const State before = currentState();
    this->Superclass::Render(renderer, volume);
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
    window->GetState()->VerifyNoActiveTextures();
    ++this->Frames;
    glGetIntegerv(GL_SAMPLES, &this->Samples);
  }

  int Frames = 0;
  int Samples = 0; // of the framebuffer
};
vtkStandardNewMacro(WatchedMapper);

void expectStateKept(Scene& scene)
{
  const bool multisampled = scene.Window->GetMultiSamples() > 1;
  for (const bool diagnostics : { true, false })
  {
    vtkNew<WatchedMapper> mapper;
    mapper->SetInputData(scene.Data);
    mapper->SetCollectDiagnostics(diagnostics);
    scene.Volume->SetMapper(mapper);
    scene.Window->Render();
    scene.Window->Render();
    EXPECT_EQ(mapper->Frames, 2);
    EXPECT_EQ(mapper->Samples > 1, multisampled);
    scene.Volume->SetMapper(scene.Mapper);
  }
}

Grid lattice() { return jitteredLattice(5, 0.15, 1, sineField()); }

TEST(GLState, IsKept)
{
  for (const int samples : { 0, 8 })
  {
    Scene scene(lattice());
    scene.Window->SetMultiSamples(samples);
    expectStateKept(scene);
    scene.Renderer->SetViewport(0.2, 0.3, 0.7, 0.9);
    expectStateKept(scene);
    scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
    expectStateKept(scene);
  }
}

TEST(GLState, IsKeptWithSearchedEntriesAndCellScalars)
{
  Scene scene(latticeWithHole(6, 0.15, 1, sineField()));
  scene.camera()->SetClippingRange(2.8, 3.2);
  expectStateKept(scene);
  scene.drawCellScalars();
  expectStateKept(scene);
}

TEST(GLState, IsKeptByTilesAndWhenTheyAreAborted)
{
  Scene scene(lattice());
  scene.Renderer->SetViewport(0.2, 0.3, 0.7, 0.9);
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
  for (const bool diagnostics : { true, false })
  {
    vtkNew<WatchedMapper> mapper;
    mapper->SetInputData(scene.Data);
    mapper->SetCollectDiagnostics(diagnostics);
    mapper->SetMaxDrawTimeInSeconds(1e-9);
    scene.Volume->SetMapper(mapper);
    scene.Window->Render();
    const int draws = mapper->GetNumberOfDraws();
    EXPECT_GT(draws, 1);
    const Observer observer(mapper, vtkCommand::ProgressEvent,
      [&] { scene.Window->SetAbortRender(mapper->GetProgress() < 1.0); });
    scene.Window->Render();
    EXPECT_LT(mapper->GetNumberOfDraws(), draws);
    EXPECT_EQ(mapper->Frames, 2);
    scene.Volume->SetMapper(scene.Mapper);
  }
}

TEST(GLState, IsKeptWhenNothingIsDrawn)
{
  Scene scene(lattice());
  vtkNew<WatchedMapper> mapper;
  mapper->SetInputData(scene.Data);
  scene.Volume->SetMapper(mapper);
  setPlainFunctions(scene.property(), { 1.0, 1.0, 1.0 }, 0.0);
  scene.Window->Render();
  EXPECT_EQ(mapper->Frames, 1);
}

// VTK skips glUseProgram() if it believes a program is in use already.
TEST(GLState, OtherPropsAreDrawnAsWithoutIt)
{
  const auto makeRight = []
  {
    vtkNew<vtkRenderer> right;
    right->SetViewport(0.5, 0.0, 1.0, 1.0);
    lookAtUnitCube(right->GetActiveCamera());
    right->AddActor(makePlane(0.2, 0.0, { 0.1, 0.9, 0.3 }));
    const auto glass = makeBall({ 0.5, 0.5, 0.5 }, 0.4, { 1.0, 0.2, 0.2 });
    glass->GetProperty()->SetOpacity(0.5);
    right->AddActor(glass);
    return vtkSmartPointer<vtkRenderer>(right);
  };
  Scene scene(lattice(), 200, 100);
  scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
  scene.Window->AddRenderer(makeRight());
  scene.Window->Render();
  scene.Window->Render();

  const auto other = makeWindow(200, 100);
  other->AddRenderer(makeRight());
  other->Render();
  const Image a = cropped(framePictureOf(scene.Window), 100, 0, 100, 100);
  const Image b = cropped(framePictureOf(other), 100, 0, 100, 100);
  EXPECT_EQ(compare(a, b, {}, 0.0, Channels::Rgb).Max, 0.0);
  EXPECT_GT(compare(a, Image(100, 100)).Max, 0.5);
}
} // namespace
