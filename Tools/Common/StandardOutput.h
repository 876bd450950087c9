// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the programs print.
 */
#ifndef tetmarch_StandardOutput_h
#define tetmarch_StandardOutput_h

#include <string_view>

namespace tetmarch
{

/// Throws Failure if standard output doesn't take all of it, as on a full disk.
void PrintText(std::string_view text);

} // namespace tetmarch

#endif
