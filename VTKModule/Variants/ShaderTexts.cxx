// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Variants/ShaderTexts.h"

#include "Variants/ShaderSource.h"

namespace tetmarch
{

const std::string& ShaderTexts::of(const std::string& file, const std::string& defines)
{
  const auto which = std::make_pair(file, defines);
  const auto found = this->Texts.find(which);
  return found != this->Texts.end()
           ? found->second
           : this->Texts.emplace(which, shaderSource(file, defines)).first->second;
}

} // namespace tetmarch
