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

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_LIT_FEATURES | TETMARCH_WITH_COLOR_AND_OPACITY | TETMARCH_WITH_POINT_SCALARS |         \
    TETMARCH_WITH_ADAPTIVE)
template <typename Real>
struct LitColorAndOpacityPointKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_LIT_FEATURES | TETMARCH_WITH_COLOR_AND_OPACITY | TETMARCH_WITH_POINT_SCALARS |         \
    TETMARCH_WITH_ADAPTIVE | TETMARCH_WITH_CELL_GRADIENTS)
template <typename Real>
struct LitColorAndOpacityCellGradientKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_LIT_FEATURES | TETMARCH_WITH_COLOR_AND_OPACITY)
template <typename Real>
struct LitColorAndOpacityCellKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_LIT_FEATURES | TETMARCH_WITH_DIRECT_COLOR | TETMARCH_WITH_POINT_SCALARS |              \
    TETMARCH_WITH_ADAPTIVE)
template <typename Real>
struct LitDirectColorPointKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_LIT_FEATURES | TETMARCH_WITH_DIRECT_COLOR | TETMARCH_WITH_POINT_SCALARS |              \
    TETMARCH_WITH_ADAPTIVE | TETMARCH_WITH_CELL_GRADIENTS)
template <typename Real>
struct LitDirectColorCellGradientKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_LIT_FEATURES | TETMARCH_WITH_DIRECT_COLOR)
template <typename Real>
struct LitDirectColorCellKernel
{
#include "Reference/KernelBody.h"
};

} // namespace tetmarch

#endif
