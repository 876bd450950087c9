// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The marches of the other blend modes than composite, compiled for the CPU like Kernel.h.
#ifndef TetMarchReferenceBlendKernel_h
#define TetMarchReferenceBlendKernel_h

#include "Reference/LitKernel.h"

namespace tetmarch
{

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_PICTURE_FEATURES | TETMARCH_WITH_EXTREME | TETMARCH_WITH_POINT_SCALARS)
template <typename Real>
struct ExtremePointKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_PICTURE_FEATURES | TETMARCH_WITH_EXTREME)
template <typename Real>
struct ExtremeCellKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_PICTURE_FEATURES | TETMARCH_WITH_SUM | TETMARCH_WITH_POINT_SCALARS)
template <typename Real>
struct SumPointKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_PICTURE_FEATURES | TETMARCH_WITH_SUM)
template <typename Real>
struct SumCellKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_PICTURE_FEATURES | TETMARCH_WITH_ISOSURFACES | TETMARCH_WITH_POINT_SCALARS)
template <typename Real>
struct IsosurfacePointKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_PICTURE_FEATURES | TETMARCH_WITH_ISOSURFACES)
template <typename Real>
struct IsosurfaceCellKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_LIT_SURFACE_FEATURES | TETMARCH_WITH_POINT_SCALARS)
template <typename Real>
struct LitIsosurfacePointKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_LIT_SURFACE_FEATURES | TETMARCH_WITH_POINT_SCALARS | TETMARCH_WITH_CELL_GRADIENTS)
template <typename Real>
struct LitIsosurfaceGradientKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_LIT_SURFACE_FEATURES)
template <typename Real>
struct LitIsosurfaceCellKernel
{
#include "Reference/KernelBody.h"
};

} // namespace tetmarch

#endif
