// What rays towards the light read; bound by GL/LightBinding.
uniform int shadowSourceCount;
uniform vec4 shadowSource[MOST_SHADOW_SOURCES]; // in the normalised frame: position, 1; or unit vector to the light, 0
uniform float lightReach; // length up to which rays towards a light are marched

vec4 fetchShadowSource(int i) { return shadowSource[i]; }
