// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The marches that look where a ray is picked, compiled for the CPU like Reference/Kernel.h.
#ifndef tetmarch_testing_PickKernels_h
#define tetmarch_testing_PickKernels_h

#include "Reference/LitKernel.h"

namespace tetmarch::testing
{
#define TETMARCH_HAS_FMA 1
#define TETMARCH_BVH 1
#define TETMARCH_PICKED 1
#define TETMARCH_CLIPPED 1
#define TETMARCH_CROPPED 1
#define TETMARCH_HIDDEN_CELLS 1

#define TETMARCH_COMPOSITE 1
#define TETMARCH_NAN_SHOWN 1
#define TETMARCH_EFFECTS 1
#define TETMARCH_GRADIENT_OPACITY 1
#define TETMARCH_POINT_SCALARS 1
#define TETMARCH_CELL_GRADIENTS 1
template <typename Real>
struct PickCellGradientKernel
{
#include "Reference/KernelBody.h"
};
#undef TETMARCH_CELL_GRADIENTS
#define TETMARCH_VERTEX_GRADIENTS 1
template <typename Real>
struct PickPointKernel
{
#include "Reference/KernelBody.h"
};
#undef TETMARCH_POINT_SCALARS
#define TETMARCH_POINT_SCALARS 0
template <typename Real>
struct PickCellKernel
{
#include "Reference/KernelBody.h"
};
#undef TETMARCH_POINT_SCALARS
#undef TETMARCH_VERTEX_GRADIENTS
#undef TETMARCH_GRADIENT_OPACITY
#undef TETMARCH_EFFECTS
#undef TETMARCH_NAN_SHOWN
#undef TETMARCH_COMPOSITE

#define TETMARCH_POINT_SCALARS 1
#define TETMARCH_EXTREME 1
template <typename Real>
struct PickExtremeKernel
{
#include "Reference/KernelBody.h"
};
#undef TETMARCH_EXTREME
#define TETMARCH_SUM 1
template <typename Real>
struct PickSumKernel
{
#include "Reference/KernelBody.h"
};
#undef TETMARCH_SUM
#define TETMARCH_ISOSURFACES 1
#define TETMARCH_PASSES_CELLS 1
template <typename Real>
struct PickIsosurfaceKernel
{
#include "Reference/KernelBody.h"
};
#undef TETMARCH_PASSES_CELLS
#undef TETMARCH_ISOSURFACES
#undef TETMARCH_POINT_SCALARS

#undef TETMARCH_HIDDEN_CELLS
#undef TETMARCH_CROPPED
#undef TETMARCH_CLIPPED
#undef TETMARCH_PICKED
#undef TETMARCH_BVH
#undef TETMARCH_HAS_FMA
} // namespace tetmarch::testing

#endif
