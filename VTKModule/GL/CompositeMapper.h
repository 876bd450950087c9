// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// VTK's mapper of composite data that has attributes of blocks.
#ifndef TetMarchGLCompositeMapper_h
#define TetMarchGLCompositeMapper_h

#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper2.h"
#else
#include "vtkCompositePolyDataMapper.h"
#endif

namespace tetmarch
{

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0)
using CompositeMapper = vtkCompositePolyDataMapper2;
#else
using CompositeMapper = vtkCompositePolyDataMapper;
#endif

} // namespace tetmarch

#endif
