// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the GL has been given for a scene, to be compared
 */
#ifndef tetmarch_testing_Held_h
#define tetmarch_testing_Held_h

#include "GLObjects.h"
#include "Scene.h"

namespace tetmarch::testing
{
/// The bytes that shadows along rays need: a tile of noise.
constexpr vtkTypeInt64 JitterBytes = 4 * 64 * 64;
/// The bytes of light at vertices, so few that one row of blocks holds them: starts of rays,
/// texels.
constexpr vtkTypeInt64 vertexLightBytes(vtkTypeInt64 vertices)
{
  return 16 * vertices + 8 * 8 * 4096;
}

struct Held
{
  explicit Held(Scene& scene)
    : Bytes(scene.Mapper->GetGPUMemoryBytes())
    , Objects(countGLObjects())
  {
  }
  bool operator==(const Held& other) const
  {
    return this->Bytes == other.Bytes && this->Objects == other.Objects;
  }
  vtkTypeInt64 Bytes;
  std::array<int, 5> Objects;
};
} // namespace tetmarch::testing

#endif
