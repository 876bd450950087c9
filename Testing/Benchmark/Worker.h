// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The process that draws one dataset by one mapper, a frame whenever it is told to
 *
 * Commands come line by line on standard input until it ends: "frame", "figures", "reference FILE"
 * (write the true picture of the first view), "errors FILE" (compare with it), "effect NAME VIEW"
 * (Drawing::drawEffect()), "gl", "probes" (GLDescription.h), "parity EFFECT"
 * (Drawing::compareWithCpu()). Every answer is one line of JSON on what was standard output; the
 * first, without a command, when the scene is ready. An answer {"error": text} is the last.
 */
#ifndef tetmarch_bench_Worker_h
#define tetmarch_bench_Worker_h

#include "Options.h"

namespace tetmarch::bench
{
/// The exit status.
int runWorker(const Options& options);
} // namespace tetmarch::bench

#endif
