// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The marches that look where a ray is picked, compiled for the CPU like Reference/Kernel.h.
#ifndef tetmarch_testing_PickKernels_h
#define tetmarch_testing_PickKernels_h

#include "Reference/LitKernel.h"

namespace tetmarch::testing
{
#define TETMARCH_PICK_FEATURES                                                                     \
  (TETMARCH_MARCH_FEATURES | TETMARCH_WITH_PICKED | TETMARCH_WITH_CLIPPED | TETMARCH_WITH_CROPPED)
#define TETMARCH_PICK_VOLUME_FEATURES                                                              \
  (TETMARCH_PICK_FEATURES | TETMARCH_WITH_NAN_SHOWN | TETMARCH_WITH_GRADIENT_OPACITY)

#define TETMARCH_VARIANT (TETMARCH_PICK_VOLUME_FEATURES | TETMARCH_WITH_POINT_SCALARS)
template <typename Real>
struct PickPointKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_PICK_VOLUME_FEATURES | TETMARCH_WITH_POINT_SCALARS | TETMARCH_WITH_CELL_GRADIENTS)
template <typename Real>
struct PickCellGradientKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_PICK_VOLUME_FEATURES)
template <typename Real>
struct PickCellKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_PICK_FEATURES | TETMARCH_WITH_EXTREME | TETMARCH_WITH_POINT_SCALARS)
template <typename Real>
struct PickExtremeKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_PICK_FEATURES | TETMARCH_WITH_SUM | TETMARCH_WITH_POINT_SCALARS)
template <typename Real>
struct PickSumKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_PICK_FEATURES | TETMARCH_WITH_ISOSURFACES | TETMARCH_WITH_POINT_SCALARS)
template <typename Real>
struct PickIsosurfaceKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_IN_LATTICES(TETMARCH_PICK_FEATURES) | TETMARCH_WITH_NAN_SHOWN |                        \
    TETMARCH_WITH_POINT_SCALARS | TETMARCH_WITH_ADAPTIVE)
template <typename Real>
struct PickTrilinearKernel
{
#include "Reference/KernelBody.h"
};
} // namespace tetmarch::testing

#endif
