// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GLDescription.h"

#include "GL/ComputeDispatch.h"
#include "GL/Driver.h"
#include "GL/ErrorQueue.h"
#include "GL/PredicateCheck.h"
#include "OffscreenWindow.h"

#include "vtkOpenGLRenderWindow.h"

#include <nlohmann/json.hpp>

#include <array>
#include <string>
#include <vector>

namespace tetmarch::bench
{
namespace
{
using Json = nlohmann::json;

/// By number, since headers of some versions of VTK lack names that are newer than GL 3.2.
struct Limit
{
  const char* Name;
  GLenum Number;
  int Since = 30;  // the GL's version, 45 for 4.5
  int Indices = 0; // so many values, one by one; 0: a single value
};

constexpr Limit Limits[] = {
  { "max_texture_size", 0x0D33 },
  { "max_3d_texture_size", 0x8073 },
  { "max_array_texture_layers", 0x88FF },
  { "max_texture_buffer_size", 0x8C2B },
  { "max_texture_image_units", 0x8872 },
  { "max_combined_texture_image_units", 0x8B4D },
  { "max_vertex_texture_image_units", 0x8B4C },
  { "max_fragment_uniform_components", 0x8B49 },
  { "max_vertex_uniform_components", 0x8B4A },
  { "max_uniform_block_size", 0x8A30 },
  { "max_varying_components", 0x8B4B },
  { "max_draw_buffers", 0x8824 },
  { "max_color_attachments", 0x8CDF },
  { "max_renderbuffer_size", 0x84E8 },
  { "max_clip_distances", 0x0D32 },
  { "subpixel_bits", 0x0D50 },
  { "texture_buffer_offset_alignment", 0x919F, 43 },
  { "max_shader_storage_block_size", 0x90DE, 43 },
  { "max_fragment_shader_storage_blocks", 0x90DA, 43 },
  { "max_image_units", 0x8F38, 42 },
  { "max_compute_work_group_count", 0x91BE, 43, 3 },
  { "max_compute_work_group_size", 0x91BF, 43, 3 },
  { "max_compute_work_group_invocations", 0x90EB, 43 },
  { "max_compute_shared_memory_size", 0x8262, 43 },
  { "max_compute_shader_storage_blocks", 0x90DB, 43 },
};

constexpr GLenum TimeElapsed = 0x88BF;
constexpr int TimersSince = 33;
constexpr int Unasked = -1; // which no limit is; a GL that knows nothing of one leaves it

std::string textOf(GLenum name)
{
  const auto* text = reinterpret_cast<const char*>(glGetString(name));
  return text ? text : "";
}

int integerOf(GLenum name)
{
  GLint value = Unasked;
  glGetIntegerv(name, &value);
  return value;
}

Json known(std::int64_t value)
{
  clearErrors();
  return value == Unasked ? Json(nullptr) : Json(value);
}

Json valueOf(const Limit& limit)
{
  if (limit.Indices == 0)
  {
    GLint64 value = Unasked;
    glGetInteger64v(limit.Number, &value);
    return known(value);
  }
  Json values = Json::array();
  for (int i = 0; i < limit.Indices; ++i)
  {
    GLint value = Unasked;
    glGetIntegeri_v(limit.Number, static_cast<GLuint>(i), &value);
    values.push_back(known(value));
  }
  return values;
}

Json limitsOf(int version)
{
  Json limits;
  for (const Limit& limit : Limits)
  {
    limits[limit.Name] = version < limit.Since ? Json(nullptr) : valueOf(limit);
  }
  GLint bits = Unasked;
  if (version >= TimersSince)
  {
    glGetQueryiv(TimeElapsed, GL_QUERY_COUNTER_BITS, &bits);
  }
  limits["timer_query_counter_bits"] = known(bits);
  return limits;
}

std::vector<std::string> extensions()
{
  std::vector<std::string> names;
  const int count = integerOf(GL_NUM_EXTENSIONS);
  for (int i = 0; i < count; ++i)
  {
    const auto* name =
      reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
    names.emplace_back(name ? name : "");
  }
  return names;
}

bool has(const std::string& defines, const char* word)
{
  return defines.find(word) != std::string::npos;
}
} // namespace

Json describeGL(vtkRenderWindow* window)
{
  const GLInformation gl = GetGLInformation(window); // makes the context current
  clearErrors();
  const int version = 10 * integerOf(GL_MAJOR_VERSION) + integerOf(GL_MINOR_VERSION);
  return { { "backend", gl.Backend }, { "vendor", gl.Vendor }, { "renderer", gl.Renderer },
    { "version", gl.Version }, { "glsl_version", textOf(GL_SHADING_LANGUAGE_VERSION) },
    { "limits", limitsOf(version) }, { "extensions", extensions() } };
}

Json probeDriver(vtkRenderWindow* window)
{
  auto* gl = vtkOpenGLRenderWindow::SafeDownCast(window);
  gl->MakeCurrent();
  const std::string defines = driverDefines();
  const ComputeSupport compute = computeSupport();
  bool fused = false;
  const bool usable = findPredicate(gl, fused).empty();
  return { { "has_compute_shaders", compute.Exists },
    { "chooses_compute_shaders", compute.IsFaster }, { "predicate_is_right", usable },
    { "predicate_by_fma", fused }, { "has_texture_gather", has(defines, "TETMARCH_HAS_GATHER") },
    { "skips_helper_invocations", has(defines, "TETMARCH_SKIPS_HELPERS") } };
}
} // namespace tetmarch::bench
