// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The marches through structured volumes, compiled for the CPU like Kernel.h. Lattices with even
// planes are marched as rectilinear ones, and no block is leapt over: so pictures of the GPU that
// do both are held against marches that do not.
#ifndef TetMarchReferenceStructuredKernel_h
#define TetMarchReferenceStructuredKernel_h

#include "Reference/LitKernel.h"

namespace tetmarch
{

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_ONE_OPACITY_FEATURES) | TETMARCH_WITH_POINT_SCALARS |             \
    TETMARCH_WITH_ADAPTIVE)
template <typename Real>
struct TrilinearKernel
{
#include "Reference/KernelBody.h"
};

// Trilinear cells that are cut evenly: of a level that keeps no tolerance.
#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_ONE_OPACITY_FEATURES) | TETMARCH_WITH_POINT_SCALARS)
template <typename Real>
struct EvenTrilinearKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT TETMARCH_IN_LATTICES(TETMARCH_ONE_OPACITY_FEATURES)
template <typename Real>
struct ConstantCellKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_PICTURE_FEATURES) | TETMARCH_WITH_POINT_SCALARS |                 \
    TETMARCH_WITH_EXTREME)
template <typename Real>
struct ExtremeTrilinearKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_IN_LATTICES(TETMARCH_PICTURE_FEATURES) | TETMARCH_WITH_EXTREME)
template <typename Real>
struct ExtremeConstantKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_PICTURE_FEATURES) | TETMARCH_WITH_POINT_SCALARS |                 \
    TETMARCH_WITH_SUM)
template <typename Real>
struct SumTrilinearKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_IN_LATTICES(TETMARCH_PICTURE_FEATURES) | TETMARCH_WITH_SUM)
template <typename Real>
struct SumConstantKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_LIT_SURFACE_FEATURES) | TETMARCH_WITH_POINT_SCALARS)
template <typename Real>
struct LitIsosurfaceTrilinearKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_LIT_SURFACE_FEATURES) | TETMARCH_WITH_POINT_SCALARS |             \
    TETMARCH_WITH_CELL_GRADIENTS)
template <typename Real>
struct LitIsosurfaceTrilinearGradientKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT TETMARCH_IN_LATTICES(TETMARCH_LIT_SURFACE_FEATURES)
template <typename Real>
struct LitIsosurfaceConstantKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_PICTURE_FEATURES) | TETMARCH_WITH_ISOSURFACES |                   \
    TETMARCH_WITH_POINT_SCALARS)
template <typename Real>
struct IsosurfaceTrilinearKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_PICTURE_FEATURES) | TETMARCH_WITH_ISOSURFACES)
template <typename Real>
struct IsosurfaceConstantKernel
{
#include "Reference/KernelBody.h"
};

// By samples at even distances.

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_ONE_OPACITY_FEATURES) | TETMARCH_WITH_POINT_SCALARS |             \
    TETMARCH_WITH_POINT_SAMPLED)
template <typename Real>
struct SampledTrilinearKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_ONE_OPACITY_FEATURES) | TETMARCH_WITH_POINT_SAMPLED)
template <typename Real>
struct SampledConstantKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_LIT_FEATURES) | TETMARCH_WITH_POINT_SCALARS |                     \
    TETMARCH_WITH_POINT_SAMPLED)
template <typename Real>
struct LitSampledTrilinearKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_LIT_FEATURES) | TETMARCH_WITH_POINT_SCALARS |                     \
    TETMARCH_WITH_CELL_GRADIENTS | TETMARCH_WITH_POINT_SAMPLED)
template <typename Real>
struct LitSampledTrilinearGradientKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_IN_LATTICES(TETMARCH_LIT_FEATURES) | TETMARCH_WITH_POINT_SAMPLED)
template <typename Real>
struct LitSampledConstantKernel
{
#include "Reference/KernelBody.h"
};

// In light. Rays towards the light gather extinction alone; castPlainRay() marches them as the
// picture is.

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_LIGHT_RAY_FEATURES) | TETMARCH_WITH_POINT_SCALARS)
template <typename Real>
struct LightRayTrilinearKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT TETMARCH_IN_LATTICES(TETMARCH_LIGHT_RAY_FEATURES)
template <typename Real>
struct LightRayConstantKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_LIT_FEATURES) | TETMARCH_WITH_POINT_SCALARS |                     \
    TETMARCH_WITH_ADAPTIVE)
template <typename Real>
struct LitTrilinearKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_LIT_FEATURES) | TETMARCH_WITH_POINT_SCALARS |                     \
    TETMARCH_WITH_ADAPTIVE | TETMARCH_WITH_CELL_GRADIENTS)
template <typename Real>
struct LitTrilinearGradientKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_IN_LATTICES(TETMARCH_LIT_FEATURES) | TETMARCH_WITH_POINT_SCALARS)
template <typename Real>
struct LitEvenTrilinearKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_LIT_FEATURES) | TETMARCH_WITH_POINT_SCALARS |                     \
    TETMARCH_WITH_CELL_GRADIENTS)
template <typename Real>
struct LitEvenTrilinearGradientKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT TETMARCH_IN_LATTICES(TETMARCH_LIT_FEATURES)
template <typename Real>
struct LitConstantKernel
{
#include "Reference/KernelBody.h"
};

} // namespace tetmarch

#endif
