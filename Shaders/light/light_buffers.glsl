// What rays towards the light need.
uniform int shadowSourceCount;
uniform vec4 shadowSource[3]; // in the mesh's frame: position, 1; or unit vector to the light, 0
uniform float lightReach;     // how far light is followed
uniform mat3 thicknessMatrix;    // direction -> world, in scalar opacity unit distances

vec4 fetchShadowSource(int i) { return shadowSource[i]; }
float thicknessPerDepthAlong(vec3 direction) { return length(thicknessMatrix * direction); }

#if !TETMARCH_SAMPLED_SHADOWS
uniform int occlusionDirectionCount;
uniform float occlusionRadius;
uniform usamplerBuffer vertexStartBuffer;
uvec4 fetchVertexStart(uint vertex) { return texelFetch(vertexStartBuffer, int(vertex)); }
#if TETMARCH_OPAQUE_SHADOWS
uniform usamplerBuffer opaqueShadowBuffer; // of each vertex, a bit a light
uint fetchOpaqueShadows(uint vertex) { return texelFetch(opaqueShadowBuffer, int(vertex)).x; }
#endif
#endif
