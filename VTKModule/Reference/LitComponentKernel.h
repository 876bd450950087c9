// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The marches of dependent components with all effects, compiled for the CPU like Kernel.h.
#ifndef TetMarchReferenceLitComponentKernel_h
#define TetMarchReferenceLitComponentKernel_h

#include "Appearance/Components.h"
#include "Reference/LitKernel.h"
#include "Scalars/FurtherScalars.h"

#include <vector>

namespace tetmarch
{

#define TETMARCH_HAS_FMA 1
#define TETMARCH_BVH 1
#define TETMARCH_DIAGNOSTICS 1
#define TETMARCH_COMPOSITE 1
#define TETMARCH_COMPONENTS 1
#define TETMARCH_DEPENDENT 1
#define TETMARCH_EFFECTS 1
#define TETMARCH_NAN_SHOWN 1
#define TETMARCH_HIDDEN_CELLS 1
#define TETMARCH_GRADIENT_OPACITY 1
#define TETMARCH_CLIPPED 1
#define TETMARCH_CROPPED 1
#define TETMARCH_TRANSPARENT_RANGES 1
#define TETMARCH_PASSES_CELLS 1
#define TETMARCH_SHADING 1
#define TETMARCH_LIT 1
#define TETMARCH_LIGHT_ERROR 1
#define TETMARCH_WORLD_LIGHTS 1
#define TETMARCH_SCATTERING 1
#define TETMARCH_SHADOWS 1
#define TETMARCH_CAST_SHADOWS 1
#define TETMARCH_SEVERAL_SHADOWS 1
#define TETMARCH_HEADLIGHT_SHADOWS 1
#define TETMARCH_OCCLUSION 1
#define TETMARCH_VERTEX_LIGHT 1
#define TETMARCH_EXACT_LIGHT 1

// Scalars of cells.
#define TETMARCH_VERTEX_GRADIENTS 1
template <typename Real>
struct LitColorAndOpacityCellKernel
{
#include "KernelBody.h"
};
#define TETMARCH_DIRECT_COLOR 1
template <typename Real>
struct LitDirectColorCellKernel
{
#include "KernelBody.h"
};

// Of points.
#define TETMARCH_POINT_SCALARS 1
#define TETMARCH_ERROR_BOUND 1
#define TETMARCH_ADAPTIVE 1
template <typename Real>
struct LitDirectColorPointKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_DIRECT_COLOR
template <typename Real>
struct LitColorAndOpacityPointKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_VERTEX_GRADIENTS
#define TETMARCH_CELL_GRADIENTS 1
template <typename Real>
struct LitColorAndOpacityCellGradientKernel
{
#include "KernelBody.h"
};
#define TETMARCH_DIRECT_COLOR 1
template <typename Real>
struct LitDirectColorCellGradientKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_DIRECT_COLOR
#undef TETMARCH_CELL_GRADIENTS
#undef TETMARCH_ADAPTIVE
#undef TETMARCH_ERROR_BOUND
#undef TETMARCH_POINT_SCALARS

#undef TETMARCH_EXACT_LIGHT
#undef TETMARCH_VERTEX_LIGHT
#undef TETMARCH_OCCLUSION
#undef TETMARCH_HEADLIGHT_SHADOWS
#undef TETMARCH_SEVERAL_SHADOWS
#undef TETMARCH_CAST_SHADOWS
#undef TETMARCH_SHADOWS
#undef TETMARCH_SCATTERING
#undef TETMARCH_WORLD_LIGHTS
#undef TETMARCH_LIGHT_ERROR
#undef TETMARCH_LIT
#undef TETMARCH_SHADING
#undef TETMARCH_PASSES_CELLS
#undef TETMARCH_TRANSPARENT_RANGES
#undef TETMARCH_CROPPED
#undef TETMARCH_CLIPPED
#undef TETMARCH_GRADIENT_OPACITY
#undef TETMARCH_HIDDEN_CELLS
#undef TETMARCH_NAN_SHOWN
#undef TETMARCH_EFFECTS
#undef TETMARCH_DEPENDENT
#undef TETMARCH_COMPONENTS
#undef TETMARCH_COMPOSITE
#undef TETMARCH_DIAGNOSTICS
#undef TETMARCH_BVH
#undef TETMARCH_HAS_FMA

} // namespace tetmarch

#endif
