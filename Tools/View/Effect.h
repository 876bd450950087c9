// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The effects of light that can be switched on.
 */
#ifndef tetmarch_Effect_h
#define tetmarch_Effect_h

#include "ViewState.h"

#include <vector>

namespace tetmarch
{

struct Effect
{
  const char* Name; // of the check box
  const char* Help;
  bool (*IsOn)(const ViewState&);
  void (*Set)(ViewState&, bool on);
};

const std::vector<Effect>& GetEffects();

} // namespace tetmarch

#endif
