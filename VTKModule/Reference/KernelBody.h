// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Included in a class template over Real: the shared files of Shaders/ as member functions, and
// what the GPU has as uniforms and texture buffers as data members. TETMARCH_VARIANT says which
// features the kernel has; it is undefined behind it. No include guard: each kernel includes it
// anew.

// Some variants do not use all parameters.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"

using uint = std::uint32_t;
using vec2 = glsl::Vec2<Real>;
using vec3 = glsl::Vec3<Real>;
using vec4 = glsl::Vec4<Real>;
using uvec2 = glsl::Vec2<uint>;
using uvec3 = glsl::Vec3<uint>;
using uvec4 = glsl::Vec4<uint>;

using ivec3 = glsl::Vec3<int>;

const IntegralTable* Table = nullptr;
const uint* HiddenCells = nullptr; // a bit a cell; nullptr: no cell is hidden

int mostSteps = 0;
int tableSize = 0;
Real tableScale = 0;
Real tableOffset = 0;
vec4 transparentRanges{ Real(-3e38), Real(3e38), 1, 0 }; // none
vec4 tableIntegralUnit{ 0, 0, 0, 0 };
vec4 nanColor{ 0, 0, 0, 0 }; // not shown
int mostTrials = 0;
Real errorTolerance = 0;

#if TETMARCH_STRUCTURED
#include "Reference/KernelLattice.h"
#else
#include "Reference/KernelMesh.h"
#endif

#if TETMARCH_COMPONENTS
#include "Reference/KernelComponents.h"
#else
vec4 fetchTableValue(int i) const
{
  const auto& v = Table->Values[i];
  return vec4(Real(v[0]), Real(v[1]), Real(v[2]), Real(v[3]));
}
uvec4 fetchTableIntegral(int i) const
{
  const auto& v = Table->Integrals[i];
  return uvec4(v[0], v[1], v[2], v[3]);
}
Real fetchTableVariation(int i) const { return Real(Table->Variations[i]); }
vec2 fetchTableVariations(int i) const
{
  return vec2(Real(Table->Variations[i]), Real(Table->ExtinctionVariations[i]));
}
vec2 fetchTableSlopeVariations(int i) const
{
  const auto& v = Table->SlopeVariations[i];
  return vec2(Real(v[0]), Real(v[1]));
}
#endif
uint fetchHiddenCells(uint word) const { return HiddenCells ? HiddenCells[word] : 0u; }

#if !TETMARCH_COMPOSITE
#include "Reference/KernelBlending.h"
#endif

#if TETMARCH_CLIPPED
#include "Reference/KernelClipping.h"
#endif

#if TETMARCH_EFFECTS || TETMARCH_LIT_COMPONENTS
#include "Reference/KernelEffects.h"
#endif

#if TETMARCH_LIGHT_RAYS
#include "Reference/KernelLightRays.h"
#endif

/** What a ReferenceScene has for this kernel. */
template <typename Scene>
void useScene(const Scene& scene)
{
#if TETMARCH_STRUCTURED
  useLattice(*scene.Cells, *scene.Values);
  useOctree(scene.Tree);
#if TETMARCH_POINT_SAMPLED
  useSamples(scene.Samples, scene.Cells->Frame);
#endif
#else
  useMesh(*scene.Mesh);
  CellScalars = scene.CellScalars ? scene.CellScalars->data() : nullptr;
  CornerScalars = scene.CornerScalars ? scene.CornerScalars->data() : nullptr;
#endif
  HiddenCells = scene.Hidden && !scene.Hidden->empty() ? scene.Hidden->data() : nullptr;
  if (scene.NanShown)
  {
    const auto& color = scene.Table->NanColor;
    nanColor = { Real(color[0]), Real(color[1]), Real(color[2]), Real(color[3]) };
  }
#if !TETMARCH_COMPOSITE
  useBlending(*scene.Blend);
#endif
#if TETMARCH_COMPONENTS && TETMARCH_STRUCTURED
  useComponentTables(*scene.Parts, scene.Range);
#elif TETMARCH_COMPONENTS
  useComponents(*scene.Parts, *scene.Extra, scene.Range);
#endif
#if TETMARCH_CLIPPED
  useClipping(scene.Cut);
#endif
#if TETMARCH_EFFECTS || TETMARCH_LIT_COMPONENTS
  useEffects(*scene.Effects);
#endif
#if TETMARCH_LIGHT_AT_POINTS
  useLightAtPoints(scene);
#endif
#if TETMARCH_LIGHT_RAYS
  useLightRays(scene.Effects->Lights, scene.Camera);
#endif
}

#if TETMARCH_EXACT_LIGHT && TETMARCH_COMPOSITE
static constexpr bool HasVolumeLight = true;
#else
static constexpr bool HasVolumeLight = false;
#endif

#if TETMARCH_LIGHT_AT_POINTS
static constexpr bool HasLightAtPoints = true;
#else
static constexpr bool HasLightAtPoints = false;
#endif

#if TETMARCH_POINT_SAMPLED
static constexpr bool TakesSamples = true;
#else
static constexpr bool TakesSamples = false;
#endif

#define real Real
#define OUT(T) T&
#define INOUT(T) T&
#define CONSTANT static constexpr
#define precise
#define smallerOf(a, b) min(a, b)
#define largerOf(a, b) max(a, b)
#define PROJECTION_SCALE NumberRange<Real>::projectionScale()
#define PROJECTION_FLUSH NumberRange<Real>::projectionFlush()
#define NO_DEPTH Real(NoDepth)
#define TINY Real(Tiny)
#define UNDRAWN_SCALAR Real(UndrawnScalar)
#define LINK_OUTSIDE LinkOutside
#define BVH_STACK MostHierarchyDepth
#define PICK_TOLERANCE Real(PickAccuracy.ErrorTolerance)
#define LEAP_SHIFT BlockShift
#define OCTREE_NUMBER_BITS OctreeNumberBits
#define OCTREE_ROW_SHIFT OctreeRowShift
#define MOST_SHADOW_SOURCES LightUniforms::MostShadowSources

#include "march/march_files.glsl"

#if TETMARCH_TRACED
#include "Reference/KernelTrace.h"
#endif

#if TETMARCH_LIGHT_AT_POINTS
#include "Reference/KernelLightAtPoints.h"
#endif

#if TETMARCH_CLIPPED
#include "cuts/clipping.glsl"
#endif

#include "march/ray_cast.glsl"

#if TETMARCH_PICKED
#include "march/pick.glsl"
#endif

#if TETMARCH_LIGHT_RAYS
#include "light/light_ray_files.glsl"

#include "light/vertex_light.glsl"
#endif

#undef real
#undef OUT
#undef INOUT
#undef CONSTANT
#undef precise
#undef smallerOf
#undef largerOf
#undef PROJECTION_SCALE
#undef PROJECTION_FLUSH
#undef NO_DEPTH
#undef TINY
#undef UNDRAWN_SCALAR
#undef LINK_OUTSIDE
#undef BVH_STACK
#undef PICK_TOLERANCE
#undef LEAP_SHIFT
#undef OCTREE_NUMBER_BITS
#undef OCTREE_ROW_SHIFT
#undef MOST_SHADOW_SOURCES

#undef TETMARCH_VARIANT

#pragma GCC diagnostic pop
