// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The marches of dependent components of a structured volume with all effects, compiled for the CPU
// like StructuredKernel.h.
#ifndef TetMarchReferenceLitStructuredComponentKernel_h
#define TetMarchReferenceLitStructuredComponentKernel_h

#include "Appearance/Components.h"
#include "Reference/StructuredKernel.h"

#include <vector>

namespace tetmarch
{

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_LIT_FEATURES) | TETMARCH_WITH_COLOR_AND_OPACITY |                 \
    TETMARCH_WITH_POINT_SCALARS | TETMARCH_WITH_ADAPTIVE)
template <typename Real>
struct LitColorAndOpacityTrilinearKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_LIT_FEATURES) | TETMARCH_WITH_COLOR_AND_OPACITY |                 \
    TETMARCH_WITH_POINT_SCALARS | TETMARCH_WITH_ADAPTIVE | TETMARCH_WITH_CELL_GRADIENTS)
template <typename Real>
struct LitColorAndOpacityTrilinearGradientKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_LIT_FEATURES) | TETMARCH_WITH_COLOR_AND_OPACITY)
template <typename Real>
struct LitColorAndOpacityConstantKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_LIT_FEATURES) | TETMARCH_WITH_DIRECT_COLOR |                      \
    TETMARCH_WITH_POINT_SCALARS | TETMARCH_WITH_ADAPTIVE)
template <typename Real>
struct LitDirectColorTrilinearKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_LIT_FEATURES) | TETMARCH_WITH_DIRECT_COLOR |                      \
    TETMARCH_WITH_POINT_SCALARS | TETMARCH_WITH_ADAPTIVE | TETMARCH_WITH_CELL_GRADIENTS)
template <typename Real>
struct LitDirectColorTrilinearGradientKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_IN_LATTICES(TETMARCH_LIT_FEATURES) | TETMARCH_WITH_DIRECT_COLOR)
template <typename Real>
struct LitDirectColorConstantKernel
{
#include "Reference/KernelBody.h"
};

} // namespace tetmarch

#endif
