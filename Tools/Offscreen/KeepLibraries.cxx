// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// For TETMARCH_SANITIZE only: no library is unloaded. LeakSanitizer knows whose leak it is by where
// code lies when the process ends, and EGL unloads its drivers before that.
#include <dlfcn.h>

extern "C" int dlclose(void*) noexcept { return 0; }
