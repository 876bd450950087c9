// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Variants/ShaderStage.h"

#include <regex>

namespace tetmarch
{

// Two of the 66 TPCs of an H100 process fragments (NVIDIA 2022, "NVIDIA H100 Tensor Core GPU
// Architecture"). Other data centre GPUs are assumed to be similar.
bool hasFewFragmentUnits(const std::string& renderer)
{
  static const std::regex names("\\b(H100|H200|H800|H20|GH200|B100|B200|B300|GB200|GB300)\\b");
  return std::regex_search(renderer, names);
}

} // namespace tetmarch
