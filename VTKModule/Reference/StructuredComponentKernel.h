// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The marches of several components of a structured volume, compiled for the CPU like
// StructuredKernel.h.
#ifndef TetMarchReferenceStructuredComponentKernel_h
#define TetMarchReferenceStructuredComponentKernel_h

#include "Appearance/Components.h"
#include "Reference/StructuredKernel.h"

#include <vector>

namespace tetmarch
{

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_VOLUME_FEATURES) | TETMARCH_WITH_INDEPENDENT |                    \
    TETMARCH_WITH_POINT_SCALARS | TETMARCH_WITH_ADAPTIVE)
template <typename Real>
struct IndependentTrilinearKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_VOLUME_FEATURES) | TETMARCH_WITH_INDEPENDENT)
template <typename Real>
struct IndependentConstantKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_ONE_OPACITY_FEATURES) | TETMARCH_WITH_COLOR_AND_OPACITY |         \
    TETMARCH_WITH_POINT_SCALARS | TETMARCH_WITH_ADAPTIVE)
template <typename Real>
struct ColorAndOpacityTrilinearKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_ONE_OPACITY_FEATURES) | TETMARCH_WITH_COLOR_AND_OPACITY)
template <typename Real>
struct ColorAndOpacityConstantKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_ONE_OPACITY_FEATURES) | TETMARCH_WITH_DIRECT_COLOR |              \
    TETMARCH_WITH_POINT_SCALARS | TETMARCH_WITH_ADAPTIVE)
template <typename Real>
struct DirectColorTrilinearKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_ONE_OPACITY_FEATURES) | TETMARCH_WITH_DIRECT_COLOR)
template <typename Real>
struct DirectColorConstantKernel
{
#include "Reference/KernelBody.h"
};

} // namespace tetmarch

#endif
