// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/BlockAttributes.h"

#include "GL/CompositeMapper.h"

namespace tetmarch
{

vtkCompositeDataDisplayAttributes* blockAttributes(vtkMapper* mapper)
{
  auto* composite = CompositeMapper::SafeDownCast(mapper);
  return composite ? composite->GetCompositeDataDisplayAttributes() : nullptr;
}

} // namespace tetmarch
