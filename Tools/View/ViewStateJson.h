// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Sessions: the state of a view as JSON.
 */
#ifndef tetmarch_ViewStateJson_h
#define tetmarch_ViewStateJson_h

#include "ViewState.h"

namespace tetmarch
{

std::string WriteState(const ViewState& state);

/// What is not in the text has its default. Throws Failure that says what is wrong.
ViewState ReadState(const std::string& text);

/// In files. Throw Failure that names the file.
void SaveSession(const ViewState& state, const std::string& path);
ViewState LoadSession(const std::string& path);

} // namespace tetmarch

#endif
