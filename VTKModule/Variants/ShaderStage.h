// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The shader stage in which rays are marched, chosen for the GPU.
#ifndef TetMarchVariantsShaderStage_h
#define TetMarchVariantsShaderStage_h

#include <string>

namespace tetmarch
{

/** Values as in vtkTetMarchSettings. */
enum class ShaderStage
{
  Automatic,
  Fragment,
  Compute
};

/** Whether the GL has compute shaders (OpenGL 4.3), and whether its GPU marches faster with them.
 */
struct ComputeSupport
{
  bool Exists = false;
  bool IsFaster = false;
};

inline bool marchesByCompute(ShaderStage asked, const ComputeSupport& support)
{
  return asked == ShaderStage::Compute || (asked == ShaderStage::Automatic && support.IsFaster);
}

/** Whether a GPU of this GL_RENDERER has few units for fragments compared with compute. */
bool hasFewFragmentUnits(const std::string& renderer);

} // namespace tetmarch

#endif
