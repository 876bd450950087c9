// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/ViewPass.h"

#include "GL/ErrorQueue.h"
#include "GL/StateScope.h"

#include "vtkLookupTable.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <cmath>

namespace tetmarch
{

std::string ViewPass::draw(vtkOpenGLRenderWindow* window, const Viewport& area,
  vtkTextureObject* measures, const MeasureView& view)
{
  const ReplaceScope state(window);
  std::string error = this->upload(window, view.Table);
  vtkShaderProgram* program = error.empty() ? this->Draw.use(window, "passes/full_view.vert.glsl",
                                                "passes/view.frag.glsl", {}, error)
                                            : nullptr;
  if (!program)
  {
    return error;
  }
  const std::array<float, 4> viewport = area.asFloats();
  program->SetUniform4f("viewport", viewport.data());
  measures->Activate();
  program->SetUniformi("measureTexture", measures->GetTextureUnit());
  this->Colors->Activate();
  program->SetUniformi("colorTexture", this->Colors->GetTextureUnit());
  program->SetUniformi("measure", static_cast<int>(view.What));
  program->SetUniformi("logarithmic", view.isLogarithmic() ? 1 : 0);
  const double* range = view.Table->GetTableRange();
  std::array<float, 2> ends{};
  for (int i = 0; i < 2; ++i)
  {
    ends[i] = static_cast<float>(view.isLogarithmic() ? std::log10(range[i]) : range[i]);
  }
  program->SetUniform2f("measureRange", ends.data());
  this->Draw.drawTriangles(1);
  this->Colors->Deactivate();
  measures->Deactivate();
  return {};
}

std::string ViewPass::upload(vtkOpenGLRenderWindow* window, vtkLookupTable* table)
{
  table->Build();
  const auto size = static_cast<std::size_t>(table->GetNumberOfTableValues());
  const unsigned char* rgba = table->GetPointer(0);
  std::vector<unsigned char> colors(rgba, rgba + 4 * size);
  if (this->Colors && colors == this->Uploaded)
  {
    return {};
  }
  this->release(window);
  clearErrors();
  this->Colors = vtkSmartPointer<vtkTextureObject>::New();
  this->Colors->SetContext(window);
  this->Colors->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Colors->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->Colors->Create2DFromRaw(
    static_cast<unsigned int>(size), 1, 4, VTK_UNSIGNED_CHAR, colors.data());
  if (!hasRoom(this->Colors))
  {
    this->release(window);
    return "The GPU takes no texture of " + std::to_string(size) +
           " colours for the view. Give its lookup table fewer.";
  }
  this->Uploaded = std::move(colors);
  return {};
}

void ViewPass::release(vtkWindow* window)
{
  this->Draw.release();
  if (this->Colors)
  {
    this->Colors->ReleaseGraphicsResources(window);
    this->Colors = nullptr;
  }
  this->Uploaded.clear();
}

} // namespace tetmarch
