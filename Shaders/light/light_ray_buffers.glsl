// Uniforms of rays towards the light; bound by GL/LightBinding.
uniform int shadowSourceCount;
uniform vec4 shadowSource[MOST_SHADOW_SOURCES]; // in the normalised frame: position, 1; or unit vector to the light, 0
uniform float lightReach; // maximum length of rays towards a light

vec4 fetchShadowSource(int i) { return shadowSource[i]; }
