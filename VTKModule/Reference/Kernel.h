// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What kernels have in common. A kernel is the march of the shaders, compiled for the CPU from the
// very files that the GPU compiles: in float it is the arithmetic of the GPU, in double the ground
// truth is made of it. Reference/Kernels.cmake writes one header for each kernel.
#ifndef TetMarchReferenceKernel_h
#define TetMarchReferenceKernel_h

#include "Appearance/Blending.h"
#include "Appearance/Components.h"
#include "Entries/EntryLists.h"
#include "Entries/VisiblePart.h"
#include "Light/EffectData.h"
#include "Mesh/BoundaryHierarchy.h"
#include "Mesh/PackedCells.h"
#include "Mesh/VertexStarts.h"
#include "Optics/IntegralTable.h"
#include "Reference/GlslLanguage.h"
#include "Reference/IncomingLight.h"
#include "Reference/RayTrace.h"
#include "Reference/ThicknessPerDepth.h"
#include "Scalars/ExtraScalars.h"
#include "Structured/EmptySpace.h"
#include "Structured/Lattice.h"
#include "Structured/LightNodes.h"
#include "Structured/MostSteps.h"
#include "Structured/Octree.h"
#include "Structured/StoredValues.h"
#include "Variants/Features.h"
#include "View/Clipping.h"
#include "View/RaySamples.h"

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

} // namespace tetmarch

#endif
