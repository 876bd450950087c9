// Uniforms of rays towards the light; bound by GL/LightBinding.
uniform int shadowSourceCount;
uniform vec4 shadowSource[MOST_SHADOW_SOURCES]; // in the normalised frame: position, 1; or unit vector to the light, 0
uniform float lightReach; // maximum length of rays towards a light

#if TETMARCH_COUNTS_TURNS
uniform int expectedLightTurns; // of the loops of the rays from a sample; at least 1
#endif

vec4 fetchShadowSource(int i) { return shadowSource[i]; }

#if TETMARCH_SAMPLED_SURFACES
#include "light/opaque_surface_buffers.glsl"
#endif

#if TETMARCH_SAMPLED_SHADOWS && !TETMARCH_SAMPLED_OCCLUSION
const int occlusionDirectionCount = 0; // ambient light is that of vertices
const float occlusionRadius = 0.0;
#else
uniform int occlusionDirectionCount;
uniform float occlusionRadius;
#endif
