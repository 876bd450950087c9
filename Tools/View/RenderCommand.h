// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state of a view as a command line of tetmarch-render that draws the same picture.
 */
#ifndef tetmarch_RenderCommand_h
#define tetmarch_RenderCommand_h

#include "ViewState.h"

namespace tetmarch
{

/// For a shell. The transfer functions come as a preset from its standard input. What the options
/// of tetmarch-render can't say is named in comments in front.
std::string WriteCommand(const ViewState& state, const std::string& output);

/// The functions as a preset of ParaView.
std::string WritePreset(const FunctionState& functions);

} // namespace tetmarch

#endif
