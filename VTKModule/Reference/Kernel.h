// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The march of the shaders, compiled for the CPU: in float it is the arithmetic of the GPU, in
// double the ground truth is made of it. Both are made of the very files that the GPU compiles.
// These kernels march a volume of one scalar without effects.
#ifndef TetMarchReferenceKernel_h
#define TetMarchReferenceKernel_h

#include "Appearance/Blending.h"
#include "Entries/EntryLists.h"
#include "Entries/VisiblePart.h"
#include "Mesh/BoundaryHierarchy.h"
#include "Mesh/PackedCells.h"
#include "Mesh/VertexStarts.h"
#include "Optics/IntegralTable.h"
#include "Rays/Clipping.h"
#include "Rays/RaySamples.h"
#include "Reference/GlslLanguage.h"
#include "Reference/KernelFeatures.h"
#include "Reference/RayTrace.h"
#include "Structured/EmptySpace.h"
#include "Structured/Lattice.h"
#include "Structured/LightNodes.h"
#include "Structured/MostSteps.h"
#include "Structured/StoredValues.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

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

/** Words of the shaders: behind every depth, and a number that keeps divisors from 0. */
constexpr double NoDepth = 3e38;
constexpr double Tiny = 1e-30;

using namespace glsl;

#define TETMARCH_VARIANT                                                                           \
  (TETMARCH_ONE_OPACITY_FEATURES | TETMARCH_WITH_POINT_SCALARS | TETMARCH_WITH_ADAPTIVE)
template <typename Real>
struct PointKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT                                                                           \
  ((TETMARCH_ONE_OPACITY_FEATURES | TETMARCH_WITH_POINT_SCALARS | TETMARCH_WITH_ADAPTIVE) &        \
    ~TETMARCH_WITH_HAS_FMA)
/** With the predicate for GLSL 1.50 without fused multiply-add; meant for float. */
template <typename Real>
struct PortablePointKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_ONE_OPACITY_FEATURES | TETMARCH_WITH_POINT_SCALARS)
/** Does not split segments. */
template <typename Real>
struct FastPointKernel
{
#include "Reference/KernelBody.h"
};

#define TETMARCH_VARIANT (TETMARCH_ONE_OPACITY_FEATURES)
template <typename Real>
struct CellKernel
{
#include "Reference/KernelBody.h"
};

} // namespace tetmarch

#endif
