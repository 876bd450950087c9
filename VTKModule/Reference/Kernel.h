// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The march of the shaders, compiled for the CPU: in float it is the arithmetic of the GPU, in
// double the yardstick. Both are made of the very files that the GPU compiles.
#ifndef TetMarchReferenceKernel_h
#define TetMarchReferenceKernel_h

#include "Appearance/Blending.h"
#include "Mesh/BoundaryHierarchy.h"
#include "Mesh/TetMesh.h"
#include "Optics/IntegralTable.h"
#include "Rays/Clipping.h"
#include "Reference/GlslLanguage.h"
#include "Reference/RayTrace.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace tetmarch
{

/** Bounds that keep products of projected coordinates in the range of normal numbers. */
template <typename Real>
struct NumberRange;
template <>
struct NumberRange<float>
{
  static float projectionScale() { return 65536.0f; }
  static float projectionFlush() { return 9.094947e-13f; } // 2^-40
};
template <>
struct NumberRange<double>
{
  static double projectionScale() { return 1.0; }
  static double projectionFlush() { return 1e-120; }
};

using namespace glsl;

#define TETMARCH_HAS_FMA 1
#define TETMARCH_BVH 1
#define TETMARCH_DIAGNOSTICS 1
#define TETMARCH_COMPOSITE 1
#define TETMARCH_TRANSPARENT_RANGES 1
#define TETMARCH_CLIPPED 1
#define TETMARCH_CROPPED 1
#define TETMARCH_NAN_SHOWN 1
#define TETMARCH_HIDDEN_CELLS 1
#define TETMARCH_PASSES_CELLS 1

#define TETMARCH_POINT_SCALARS 1
#define TETMARCH_ERROR_BOUND 1
#define TETMARCH_ADAPTIVE 1
template <typename Real>
struct PointKernel
{
#include "KernelBody.h"
};

#undef TETMARCH_HAS_FMA
#define TETMARCH_HAS_FMA 0
/** With the predicate for GLSL 1.50 without fused multiply-add; meant for float. */
template <typename Real>
struct PortablePointKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_HAS_FMA
#define TETMARCH_HAS_FMA 1

#undef TETMARCH_ADAPTIVE
#define TETMARCH_ADAPTIVE 0
/** Takes segments as they are. */
template <typename Real>
struct FastPointKernel
{
#include "KernelBody.h"
};

#undef TETMARCH_POINT_SCALARS
#undef TETMARCH_ERROR_BOUND
#define TETMARCH_POINT_SCALARS 0
#define TETMARCH_ERROR_BOUND 0
template <typename Real>
struct CellKernel
{
#include "KernelBody.h"
};
#undef TETMARCH_POINT_SCALARS
#undef TETMARCH_ERROR_BOUND
#undef TETMARCH_ADAPTIVE

#undef TETMARCH_HAS_FMA
#undef TETMARCH_BVH
#undef TETMARCH_DIAGNOSTICS
#undef TETMARCH_COMPOSITE
#undef TETMARCH_TRANSPARENT_RANGES
#undef TETMARCH_CLIPPED
#undef TETMARCH_CROPPED
#undef TETMARCH_NAN_SHOWN
#undef TETMARCH_HIDDEN_CELLS
#undef TETMARCH_PASSES_CELLS

} // namespace tetmarch

#endif
