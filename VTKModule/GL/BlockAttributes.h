// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which blocks of composite data are drawn, and how.
#ifndef TetMarchGLBlockAttributes_h
#define TetMarchGLBlockAttributes_h

class vtkCompositeDataDisplayAttributes;
class vtkMapper;

namespace tetmarch
{

/** nullptr if the mapper knows of none. */
vtkCompositeDataDisplayAttributes* blockAttributes(vtkMapper* mapper);

} // namespace tetmarch

#endif
