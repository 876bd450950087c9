// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The attributes with which a mapper draws blocks of composite data.
#ifndef TetMarchGLBlockAttributes_h
#define TetMarchGLBlockAttributes_h

class vtkCompositeDataDisplayAttributes;
class vtkMapper;

namespace tetmarch
{

/** nullptr if the mapper has none. */
vtkCompositeDataDisplayAttributes* blockAttributes(vtkMapper* mapper);

} // namespace tetmarch

#endif
