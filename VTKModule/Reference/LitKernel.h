// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The march with all effects, and that of rays towards the light, compiled for the CPU like
// Kernel.h.
#ifndef TetMarchReferenceLitKernel_h
#define TetMarchReferenceLitKernel_h

#include "Light/EffectData.h"
#include "Reference/Kernel.h"
#include "Reference/ThicknessPerDepth.h"

namespace tetmarch
{

/** How much light comes through the volume to a point of the normalised frame: ambient, then from
 * up to three lights. */
template <typename Real>
class IncomingLight
{
public:
  virtual ~IncomingLight() = default;
  virtual glsl::Vec4<Real> at(glsl::Vec3<Real> point) const = 0;
};

#define TETMARCH_HAS_FMA 1
#define TETMARCH_BVH 1
#define TETMARCH_DIAGNOSTICS 1
#define TETMARCH_COMPOSITE 1
#define TETMARCH_EFFECTS 1
#define TETMARCH_NAN_SHOWN 1
#define TETMARCH_HIDDEN_CELLS 1
#define TETMARCH_GRADIENT_OPACITY 1

// Rays towards the light: extinction alone, and for brute force the march of the picture.
#define TETMARCH_LIGHT_RAYS 1
#define TETMARCH_OPAQUE_SHADOWS 1
#define TETMARCH_VERTEX_GRADIENTS 1
#define TETMARCH_POINT_SCALARS 1
template <typename Real>
struct LightRayKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_POINT_SCALARS
#define TETMARCH_POINT_SCALARS 0
template <typename Real>
struct LightRayCellKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_POINT_SCALARS
#define TETMARCH_POINT_SCALARS 1
#undef TETMARCH_VERTEX_GRADIENTS
#define TETMARCH_CELL_GRADIENTS 1
template <typename Real>
struct LightRayCellGradientKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_LIGHT_RAYS
#undef TETMARCH_OPAQUE_SHADOWS

// Rays of the picture.
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
#define TETMARCH_ERROR_BOUND 1
#define TETMARCH_ADAPTIVE 1
template <typename Real>
struct LitCellGradientKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_CELL_GRADIENTS
#define TETMARCH_VERTEX_GRADIENTS 1
template <typename Real>
struct LitPointKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_ADAPTIVE
#define TETMARCH_ADAPTIVE 0
template <typename Real>
struct LitFastPointKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_ERROR_BOUND
#define TETMARCH_ERROR_BOUND 0
#undef TETMARCH_POINT_SCALARS
#define TETMARCH_POINT_SCALARS 0
template <typename Real>
struct LitCellKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_POINT_SCALARS
#undef TETMARCH_TRANSPARENT_RANGES
#undef TETMARCH_CROPPED
#undef TETMARCH_CLIPPED
#undef TETMARCH_PASSES_CELLS
#undef TETMARCH_ERROR_BOUND
#undef TETMARCH_ADAPTIVE
#undef TETMARCH_EXACT_LIGHT
#undef TETMARCH_VERTEX_LIGHT
#undef TETMARCH_OCCLUSION
#undef TETMARCH_HEADLIGHT_SHADOWS
#undef TETMARCH_CAST_SHADOWS
#undef TETMARCH_SEVERAL_SHADOWS
#undef TETMARCH_SHADOWS
#undef TETMARCH_SCATTERING
#undef TETMARCH_WORLD_LIGHTS
#undef TETMARCH_LIGHT_ERROR
#undef TETMARCH_LIT
#undef TETMARCH_SHADING
#undef TETMARCH_VERTEX_GRADIENTS
#undef TETMARCH_GRADIENT_OPACITY
#undef TETMARCH_EFFECTS
#undef TETMARCH_NAN_SHOWN
#undef TETMARCH_HIDDEN_CELLS
#undef TETMARCH_COMPOSITE
#undef TETMARCH_DIAGNOSTICS
#undef TETMARCH_BVH
#undef TETMARCH_HAS_FMA

} // namespace tetmarch

#endif
