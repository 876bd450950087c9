// The macros of the shared files for GLSL; Reference/KernelBody.h defines them for C++.
#if TETMARCH_ES
#include "language_es.glsl"
#else
#if TETMARCH_HAS_FMA || TETMARCH_HAS_PRECISE
#extension GL_ARB_gpu_shader5 : require
#else
#define precise
#endif

#if TETMARCH_GATHERS
#extension GL_ARB_texture_gather : require
#endif

// For passes/helper.glsl: an extension is asked for before anything is declared.
#if TETMARCH_SKIPS_HELPERS
#extension GL_ARB_ES3_1_compatibility : require
#endif

// NVIDIA's compiler unrolls loops around the rays to the light: frames take 1.6 times as long, building 1.8 times.
#if TETMARCH_SAMPLED_SHADOWS
#pragma optionNV(unroll none)
#endif

#define BUFFER_TEXEL(buffer, i) texelFetch(buffer, i)
#endif

#define real float
#define OUT(T) out T
#define INOUT(T) inout T
#define CONSTANT const

#define NO_DEPTH 3.0e38

// Uniforms that are read in a loop, as global variables. The software renderer, which has no fused multiply-add, reads
// uniforms lane by lane in each iteration of a loop: there they are expressions, since compilers undo a copy. On a GPU
// this would take registers.
#if TETMARCH_HAS_FMA || TETMARCH_STRUCTURED
#define KEPT(uniform_value) uniform_value
#define KEPT_INT(uniform_value) uniform_value
#else
#define KEPT(uniform_value) max(uniform_value, -NO_DEPTH)
#define KEPT_INT(uniform_value) max(uniform_value, -0x7fffffff)
#endif

// Of two numbers that are not NaN. The software renderer has no fused multiply-add; it takes one instruction for these,
// and three for min() and max().
#if TETMARCH_HAS_PRECISE && !TETMARCH_HAS_FMA
float smallerOf(float a, float b)
{
  precise float found = a < b ? a : b;
  return found;
}
float largerOf(float a, float b)
{
  precise float found = a > b ? a : b;
  return found;
}
#else
#define smallerOf(a, b) min(a, b)
#define largerOf(a, b) max(a, b)
#endif

#define TINY 1.0e-30
#define UNDRAWN_SCALAR 1.0e30
#define MOST_LIGHTS 16 // Light/Lighting.h
#define MOST_SHADOW_SOURCES 3 // Light/LightUniforms.h
#define MOST_CLIPPING_PLANES 38 // View/Clipping.h
#define MOST_ISOSURFACES 32 // Appearance/Blending.h
#define MOST_COMPONENTS 4 // Scalars/ExtraScalars.h
#define VERTEX_LIGHT_BLOCK 8 // texels; Light/VertexLightLayout.h
#define VERTEX_LIGHT_ROW 4096
#if TETMARCH_PICKED && TETMARCH_ADAPTIVE
#define PICK_TOLERANCE 3.90625e-3 // 1/256; Optics/AccuracyLevel.h
#endif
#if TETMARCH_STRUCTURED
#define LEAP_SHIFT 2 // a block has 1 << 2 cells along each side; Structured/EmptySpace.h
#define OCTREE_NUMBER_BITS 27 // Structured/Octree.h
#define OCTREE_ROW_SHIFT 10
#else
#define PROJECTION_SCALE 65536.0
#define PROJECTION_FLUSH 9.094947e-13 // 2^-40
#define LINK_OUTSIDE 0x80000000u
#define BVH_STACK 48 // Mesh/BoundaryHierarchy.h bounds the depth
#endif
