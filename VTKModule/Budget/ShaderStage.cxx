// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Budget/ShaderStage.h"

#include <regex>

namespace tetmarch
{

// Of the 66 TPCs of an H100 two take fragments (NVIDIA 2022, "NVIDIA H100 Tensor Core GPU
// Architecture"). Its relatives in data centres are taken to be alike.
bool hasFewFragmentUnits(const std::string& renderer)
{
  static const std::regex names("\\b(H100|H200|H800|H20|GH200|B100|B200|B300|GB200|GB300)\\b");
  return std::regex_search(renderer, names);
}

} // namespace tetmarch
