// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The march of a volume with all effects, and that of rays towards the light, compiled for the CPU
// like Kernel.h.
#ifndef TetMarchReferenceLitKernel_h
#define TetMarchReferenceLitKernel_h

#include "Light/EffectData.h"
#include "Reference/IncomingLight.h"
#include "Reference/Kernel.h"
#include "Reference/ThicknessPerDepth.h"

namespace tetmarch
{

// Rays towards the light gather extinction alone; castPlainRay() marches them as the picture is.

#define TETMARCH_VARIANT (TETMARCH_LIGHT_RAY_FEATURES | TETMARCH_WITH_POINT_SCALARS)
template <typename Real>
struct LightRayKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_LIGHT_RAY_FEATURES)
template <typename Real>
struct LightRayCellKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_LIGHT_RAY_FEATURES | TETMARCH_WITH_POINT_SCALARS | TETMARCH_WITH_CELL_GRADIENTS)
template <typename Real>
struct LightRayCellGradientKernel
{
#include "Reference/KernelBody.h"
};

// Rays of the picture.

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_LIT_FEATURES | TETMARCH_WITH_POINT_SCALARS | TETMARCH_WITH_ADAPTIVE)
template <typename Real>
struct LitPointKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_LIT_FEATURES | TETMARCH_WITH_POINT_SCALARS | TETMARCH_WITH_ADAPTIVE |                  \
    TETMARCH_WITH_CELL_GRADIENTS)
template <typename Real>
struct LitCellGradientKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_LIT_FEATURES | TETMARCH_WITH_POINT_SCALARS)
template <typename Real>
struct LitFastPointKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_LIT_FEATURES)
template <typename Real>
struct LitCellKernel
{
#include "Reference/KernelBody.h"
};

} // namespace tetmarch

#endif
