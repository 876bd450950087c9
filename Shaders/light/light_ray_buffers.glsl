// Uniforms of rays towards the light; bound by GL/LightBinding.
uniform int shadowSourceCount;
uniform vec4 shadowSource[MOST_SHADOW_SOURCES]; // in the normalised frame: position, 1; or unit vector to the light, 0
uniform float lightReach; // maximum length of rays towards a light

vec4 fetchShadowSource(int i) { return shadowSource[i]; }

#if TETMARCH_SAMPLED_SHADOWS
const int occlusionDirectionCount = 0; // ambient light is that of vertices
const float occlusionRadius = 0.0;
#else
uniform int occlusionDirectionCount;
uniform float occlusionRadius;
#endif
#if TETMARCH_LIGHT_TOLERANCE
// Per ray; the rest has the light of the last one (march/sample_pause.glsl).
#if TETMARCH_LIMITS_TURNS
uniform int mostLightSamples;
#else
const int mostLightSamples = 4096; // a guard
#endif
#endif
