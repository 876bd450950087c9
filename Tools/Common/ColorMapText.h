// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_ColorMapText_h
#define tetmarch_ColorMapText_h

namespace tetmarch
{

/// What ColorMaps.json says; it is compiled in, so that the programs need no file at run time.
extern const char* const ColorMapText;

} // namespace tetmarch

#endif
