// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The editor of transfer functions, of the functions that a model shows.
 */
#ifndef tetmarch_FunctionDock_h
#define tetmarch_FunctionDock_h

namespace tetmarch
{
class Model;
class TransferFunctionEditor;

/// The model outlives it. While somebody drags a point, frames may be coarse, so that they follow.
TransferFunctionEditor* MakeFunctionEditor(Model& model);

} // namespace tetmarch

#endif
