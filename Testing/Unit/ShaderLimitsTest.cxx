// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The numbers of Shaders/language.glsl are those of C++.
#include "Appearance/Blending.h"
#include "Light/LightUniforms.h"
#include "Light/Lighting.h"
#include "Light/VertexLightLayout.h"
#include "Mesh/BoundaryHierarchy.h"
#include "Optics/AccuracyLevel.h"
#include "Reference/Kernel.h"
#include "Scalars/DrawnScalars.h"
#include "Structured/EmptySpace.h"
#include "View/Clipping.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <string>

namespace
{
using namespace tetmarch;

// Numbers that the file defines.
std::map<std::string, double> numbersOf(const std::filesystem::path& file)
{
  std::map<std::string, double> numbers;
  std::ifstream stream(file);
  std::string define, name, value;
  for (std::string line; std::getline(stream, line);)
  {
    std::istringstream words(line);
    if (words >> define >> name >> value && define == "#define" &&
        (value[0] >= '0' && value[0] <= '9'))
    {
      // A hexadecimal number is an integer.
      numbers[name] = value.substr(0, 2) == "0x"
                        ? static_cast<double>(std::strtoull(value.c_str(), nullptr, 16))
                        : std::strtod(value.c_str(), nullptr);
    }
  }
  return numbers;
}

TEST(ShaderLimits, AreTheSameInGlslAndCxx)
{
  const std::map<std::string, double> cxx{
    { "MOST_LIGHTS", MostLights },
    { "MOST_SHADOW_SOURCES", LightUniforms::MostShadowSources },
    { "MOST_CLIPPING_PLANES", Clipping::MostPlanes },
    { "MOST_ISOSURFACES", MostIsoSurfaces },
    { "MOST_COMPONENTS", MostComponents },
    { "VERTEX_LIGHT_BLOCK", VertexLightBlockSide },
    { "VERTEX_LIGHT_ROW", VertexLightRow },
    { "BVH_STACK", MostHierarchyDepth },
    { "PICK_TOLERANCE", PickAccuracy.ErrorTolerance },
    { "LEAP_SHIFT", BlockShift },
    { "OCTREE_NUMBER_BITS", OctreeNumberBits },
    { "OCTREE_ROW_SHIFT", OctreeRowShift },
    { "LINK_OUTSIDE", LinkOutside },
    { "UNDRAWN_SCALAR", UndrawnScalar },
    { "NO_DEPTH", NoDepth },
    { "TINY", Tiny },
    { "PROJECTION_SCALE", NumberRange<float>::projectionScale() },
    { "PROJECTION_FLUSH", NumberRange<float>::projectionFlush() },
  };
  const auto glsl = numbersOf(std::filesystem::path(TETMARCH_SHADER_DIR) / "language.glsl");
  for (const auto& [name, value] : glsl)
  {
    ASSERT_EQ(cxx.count(name), 1u) << name;
    EXPECT_EQ(static_cast<float>(value), static_cast<float>(cxx.at(name))) << name;
  }
  EXPECT_EQ(glsl.size(), cxx.size());
}
} // namespace
