// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The colours of the view modes unless the user sets others.
#ifndef TetMarchDiagnosticsViewColors_h
#define TetMarchDiagnosticsViewColors_h

class vtkLookupTable;

namespace tetmarch
{

/** From dark blue to pale yellow in 256 steps of equal lightness (CIE L* from 18 to 97). */
void setViewColors(vtkLookupTable* table);

} // namespace tetmarch

#endif
