// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// For TETMARCH_SANITIZE only: libraries stay loaded until the process ends. LeakSanitizer names the
// library that leaked by its address at that time, and EGL would have unloaded its drivers before.
#include <dlfcn.h>

extern "C" int dlclose(void*) noexcept { return 0; }
