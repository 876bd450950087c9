// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The marches of the other blend modes than composite, compiled for the CPU like Kernel.h.
#ifndef TetMarchReferenceBlendKernel_h
#define TetMarchReferenceBlendKernel_h

#include "Reference/LitKernel.h"

namespace tetmarch
{

#define TETMARCH_HAS_FMA 1
#define TETMARCH_BVH 1
#define TETMARCH_DIAGNOSTICS 1
#define TETMARCH_CLIPPED 1
#define TETMARCH_CROPPED 1
#define TETMARCH_HIDDEN_CELLS 1

#define TETMARCH_EXTREME 1
#define TETMARCH_POINT_SCALARS 1
template <typename Real>
struct ExtremePointKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_POINT_SCALARS
#define TETMARCH_POINT_SCALARS 0
template <typename Real>
struct ExtremeCellKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_EXTREME

#define TETMARCH_SUM 1
template <typename Real>
struct SumCellKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_POINT_SCALARS
#define TETMARCH_POINT_SCALARS 1
template <typename Real>
struct SumPointKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_SUM

#define TETMARCH_ISOSURFACES 1
#define TETMARCH_PASSES_CELLS 1
template <typename Real>
struct IsosurfacePointKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_POINT_SCALARS
#define TETMARCH_POINT_SCALARS 0
template <typename Real>
struct IsosurfaceCellKernel
{
#include "KernelBody.h"
};

#define TETMARCH_EFFECTS 1
#define TETMARCH_SHADING 1
#define TETMARCH_LIT 1
#define TETMARCH_WORLD_LIGHTS 1
#define TETMARCH_VERTEX_GRADIENTS 1
template <typename Real>
struct LitIsosurfaceCellKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_POINT_SCALARS
#define TETMARCH_POINT_SCALARS 1
template <typename Real>
struct LitIsosurfacePointKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_VERTEX_GRADIENTS
#define TETMARCH_CELL_GRADIENTS 1
template <typename Real>
struct LitIsosurfaceGradientKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_CELL_GRADIENTS
#undef TETMARCH_WORLD_LIGHTS
#undef TETMARCH_LIT
#undef TETMARCH_SHADING
#undef TETMARCH_EFFECTS
#undef TETMARCH_PASSES_CELLS
#undef TETMARCH_ISOSURFACES
#undef TETMARCH_POINT_SCALARS

#undef TETMARCH_HIDDEN_CELLS
#undef TETMARCH_CROPPED
#undef TETMARCH_CLIPPED
#undef TETMARCH_DIAGNOSTICS
#undef TETMARCH_BVH
#undef TETMARCH_HAS_FMA

} // namespace tetmarch

#endif
