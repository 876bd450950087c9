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

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_VOLUME_FEATURES | TETMARCH_WITH_INDEPENDENT | TETMARCH_WITH_POINT_SCALARS |            \
    TETMARCH_WITH_ADAPTIVE)
template <typename Real>
struct IndependentPointKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_VOLUME_FEATURES | TETMARCH_WITH_INDEPENDENT | TETMARCH_WITH_POINT_SCALARS)
template <typename Real>
struct FastIndependentPointKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_VOLUME_FEATURES | TETMARCH_WITH_INDEPENDENT)
template <typename Real>
struct IndependentCellKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_ONE_OPACITY_FEATURES | TETMARCH_WITH_COLOR_AND_OPACITY | TETMARCH_WITH_POINT_SCALARS | \
    TETMARCH_WITH_ADAPTIVE)
template <typename Real>
struct ColorAndOpacityPointKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_ONE_OPACITY_FEATURES | TETMARCH_WITH_COLOR_AND_OPACITY | TETMARCH_WITH_POINT_SCALARS)
template <typename Real>
struct FastColorAndOpacityPointKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_ONE_OPACITY_FEATURES | TETMARCH_WITH_COLOR_AND_OPACITY)
template <typename Real>
struct ColorAndOpacityCellKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_ONE_OPACITY_FEATURES | TETMARCH_WITH_DIRECT_COLOR | TETMARCH_WITH_POINT_SCALARS |      \
    TETMARCH_WITH_ADAPTIVE)
template <typename Real>
struct DirectColorPointKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_ONE_OPACITY_FEATURES | TETMARCH_WITH_DIRECT_COLOR | TETMARCH_WITH_POINT_SCALARS)
template <typename Real>
struct FastDirectColorPointKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_ONE_OPACITY_FEATURES | TETMARCH_WITH_DIRECT_COLOR)
template <typename Real>
struct DirectColorCellKernel
{
#include "Reference/KernelBody.h"
};

} // namespace tetmarch

#endif
