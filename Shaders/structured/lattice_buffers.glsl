// The cells of a structured volume and their values; Structured/Lattice.h and Structured/StoredValues.h describe the
// conventions. Bound by GL/LatticeTextures.
uniform vec2 valueMap;      // scale and offset: from values of the texture to stored scalars
uniform ivec3 latticeCells; // along i, j, k
#if !TETMARCH_LEAF_CELLS
uniform ivec3 firstValue;   // of cell 0, along i, j, k
#endif
uniform ivec3 lastValue;
uniform mat4 latticeMatrix; // from the normalised frame to lattice coordinates
uniform int mostSteps;      // the step guard: maximum number of parts of cells on a ray

vec3 toLattice(vec3 point) { return (latticeMatrix * vec4(point, 1.0)).xyz; }
vec3 directionToLattice(vec3 direction) { return mat3(latticeMatrix) * direction; }
#if TETMARCH_EFFECTS || TETMARCH_LIT_COMPONENTS
vec3 gradientFromLattice(vec3 gradient) { return gradient * mat3(latticeMatrix); }
#endif

#if TETMARCH_GATHERS
uniform vec2 valueTexel; // reciprocal of width and height of a texture
#endif
#if TETMARCH_COMPONENTS
uniform vec2 extraMap[MOST_COMPONENTS - 1]; // as valueMap, for extra scalars

// NVIDIA's compiler refuses a constant index -1 of component 0 even behind a return.
int extraIndex(int component) { return max(component - 1, 0); }
#endif

#if TETMARCH_SLABS
#include "structured/slab_buffers.glsl"
#else
uniform sampler2DArray valueTexture; // layers along k

// Four values of a layer, in the order of textureGather(): (i, j + 1), (i + 1, j + 1), (i + 1, j), (i, j).
#if TETMARCH_GATHERS
vec4 fetchValues(int i, int j, int k)
{
  vec3 place = vec3(vec2(float(i + 1), float(j + 1)) * valueTexel, float(clamp(k, 0, lastValue.z)));
  return textureGather(valueTexture, place) * valueMap.x + vec4(valueMap.y);
}
#elif TETMARCH_POINT_SCALARS && TETMARCH_PACKED_SQUARES
// Texel (i + 1, j + 1) has these four values, where GLSL has no textureGather().
vec4 fetchValues(int i, int j, int k)
{
  ivec3 place = clamp(ivec3(i + 1, j + 1, k), ivec3(0), lastValue + ivec3(1, 1, 0));
  return texelFetch(valueTexture, place, 0) * valueMap.x + vec4(valueMap.y);
}
#elif TETMARCH_POINT_SCALARS
vec4 fetchValues(int i, int j, int k)
{
  ivec3 low = clamp(ivec3(i, j, k), ivec3(0), lastValue);
  ivec2 high = clamp(ivec2(i + 1, j + 1), ivec2(0), lastValue.xy);
  vec4 values = vec4(texelFetch(valueTexture, ivec3(low.x, high.y, low.z), 0).x,
    texelFetch(valueTexture, ivec3(high, low.z), 0).x, texelFetch(valueTexture, ivec3(high.x, low.y, low.z), 0).x,
    texelFetch(valueTexture, low, 0).x);
  return values * valueMap.x + vec4(valueMap.y);
}
#else
float fetchValue(int i, int j, int k)
{
  return texelFetch(valueTexture, clamp(ivec3(i, j, k), ivec3(0), lastValue), 0).x * valueMap.x + valueMap.y;
}
#endif

#if TETMARCH_COMPONENTS
// Values of extra drawn scalars. Samplers that are not needed are never read.
uniform sampler2DArray extraTextureA;
#if !TETMARCH_COLOR_AND_OPACITY
uniform sampler2DArray extraTextureB;
uniform sampler2DArray extraTextureC;
#endif

#if TETMARCH_POINT_SCALARS
#if TETMARCH_GATHERS
vec4 readValues(sampler2DArray values, int i, int j, int k)
{
  return textureGather(values, vec3(vec2(float(i + 1), float(j + 1)) * valueTexel, float(clamp(k, 0, lastValue.z))));
}
#else
vec4 readValues(sampler2DArray values, int i, int j, int k)
{
  ivec3 low = clamp(ivec3(i, j, k), ivec3(0), lastValue);
  ivec2 high = clamp(ivec2(i + 1, j + 1), ivec2(0), lastValue.xy);
  return vec4(texelFetch(values, ivec3(low.x, high.y, low.z), 0).x, texelFetch(values, ivec3(high, low.z), 0).x,
    texelFetch(values, ivec3(high.x, low.y, low.z), 0).x, texelFetch(values, low, 0).x);
}
#endif

// Four values of a component, in the order of fetchValues(), which reads component 0.
vec4 fetchValuesOf(int component, int i, int j, int k)
{
  if (component == 0)
  {
    return fetchValues(i, j, k);
  }
#if TETMARCH_COLOR_AND_OPACITY
  vec4 values = readValues(extraTextureA, i, j, k);
#else
  vec4 values = component == 1 ? readValues(extraTextureA, i, j, k)
    : (component == 2 ? readValues(extraTextureB, i, j, k) : readValues(extraTextureC, i, j, k));
#endif
  vec2 map = extraMap[extraIndex(component)];
  return values * map.x + vec4(map.y);
}
#else
// The extra values of a cell.
vec3 fetchExtraValues(int i, int j, int k)
{
  ivec3 place = clamp(ivec3(i, j, k), ivec3(0), lastValue);
  vec3 values = vec3(texelFetch(extraTextureA, place, 0).x, 0.0, 0.0) * extraMap[0].x + vec3(extraMap[0].y);
#if !TETMARCH_COLOR_AND_OPACITY
  values.y = texelFetch(extraTextureB, place, 0).x * extraMap[1].x + extraMap[1].y;
  values.z = texelFetch(extraTextureC, place, 0).x * extraMap[2].x + extraMap[2].y;
#endif
  return values;
}
#endif
#endif
#endif

#if TETMARCH_EFFECTS || TETMARCH_LIT_COMPONENTS
// Of a component, for its gradient.
#if TETMARCH_POINT_SCALARS && !TETMARCH_COMPONENTS
vec4 fetchValuesOf(int component, int i, int j, int k) { return fetchValues(i, j, k); }
#elif !TETMARCH_POINT_SCALARS && TETMARCH_LIT_COMPONENTS
float fetchValueOf(int component, int i, int j, int k)
{
  vec3 extra = fetchExtraValues(i, j, k);
  return component == 0 ? fetchValue(i, j, k) : (component == 1 ? extra.x : (component == 2 ? extra.y : extra.z));
}
#elif !TETMARCH_POINT_SCALARS
float fetchValueOf(int component, int i, int j, int k) { return fetchValue(i, j, k); }
#endif
#endif

#if TETMARCH_RECTILINEAR
uniform samplerBuffer planeBuffer; // those of i, of j, of k, consecutively
uniform ivec3 firstPlane;          // of each axis in the buffer
float fetchPlane(int i) { return BUFFER_TEXEL(planeBuffer, i).x; }
#else
uniform vec3 latticeShift;      // plane i is at i + latticeShift, but not beyond
uniform vec3 latticeHalfLength; // that
#endif

#if TETMARCH_LEAPS
uniform usamplerBuffer blockDistanceBuffer; // Structured/EmptySpace.h
uniform ivec3 blockCount;
int fetchBlockDistance(int i) { return int(BUFFER_TEXEL(blockDistanceBuffer, i).x); }
#endif

#if TETMARCH_LEAF_CELLS
#include "structured/octree_buffers.glsl"
#endif

#if TETMARCH_HIDDEN_CELLS
uniform usamplerBuffer hiddenCellBuffer; // one bit per cell
uint fetchHiddenCells(uint word) { return BUFFER_TEXEL(hiddenCellBuffer, int(word)).x; }
#endif
