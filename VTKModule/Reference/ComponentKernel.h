// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The marches of several components, compiled for the CPU like Kernel.h.
#ifndef TetMarchReferenceComponentKernel_h
#define TetMarchReferenceComponentKernel_h

#include "Appearance/Components.h"
#include "Reference/Kernel.h"
#include "Scalars/FurtherScalars.h"

#include <vector>

namespace tetmarch
{

#define TETMARCH_HAS_FMA 1
#define TETMARCH_BVH 1
#define TETMARCH_DIAGNOSTICS 1
#define TETMARCH_COMPOSITE 1
#define TETMARCH_CLIPPED 1
#define TETMARCH_CROPPED 1
#define TETMARCH_NAN_SHOWN 1
#define TETMARCH_HIDDEN_CELLS 1
#define TETMARCH_COMPONENTS 1

// Scalars of cells.
#define TETMARCH_INDEPENDENT 1
template <typename Real>
struct IndependentCellKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_INDEPENDENT

#define TETMARCH_DEPENDENT 1
#define TETMARCH_TRANSPARENT_RANGES 1
#define TETMARCH_PASSES_CELLS 1
template <typename Real>
struct ColorAndOpacityCellKernel
{
#include "KernelBody.h"
};
#define TETMARCH_DIRECT_COLOR 1
template <typename Real>
struct DirectColorCellKernel
{
#include "KernelBody.h"
};

// Of points.
#define TETMARCH_POINT_SCALARS 1
#define TETMARCH_ERROR_BOUND 1
template <typename Real>
struct FastDirectColorPointKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_DIRECT_COLOR
template <typename Real>
struct FastColorAndOpacityPointKernel
{
#include "KernelBody.h"
};
#define TETMARCH_ADAPTIVE 1
template <typename Real>
struct ColorAndOpacityPointKernel
{
#include "KernelBody.h"
};
#define TETMARCH_DIRECT_COLOR 1
template <typename Real>
struct DirectColorPointKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_DIRECT_COLOR
#undef TETMARCH_PASSES_CELLS
#undef TETMARCH_TRANSPARENT_RANGES
#undef TETMARCH_DEPENDENT

#define TETMARCH_INDEPENDENT 1
template <typename Real>
struct IndependentPointKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_ADAPTIVE
template <typename Real>
struct FastIndependentPointKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_INDEPENDENT
#undef TETMARCH_ERROR_BOUND
#undef TETMARCH_POINT_SCALARS

#undef TETMARCH_COMPONENTS
#undef TETMARCH_HIDDEN_CELLS
#undef TETMARCH_NAN_SHOWN
#undef TETMARCH_CROPPED
#undef TETMARCH_CLIPPED
#undef TETMARCH_COMPOSITE
#undef TETMARCH_DIAGNOSTICS
#undef TETMARCH_BVH
#undef TETMARCH_HAS_FMA

} // namespace tetmarch

#endif
