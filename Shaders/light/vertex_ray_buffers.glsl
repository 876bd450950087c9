// What rays from vertices read beside light/light_ray_buffers.glsl; bound by GL/EffectTextures.
uniform int occlusionDirectionCount;
uniform float occlusionRadius;
#if !TETMARCH_STRUCTURED
uniform usamplerBuffer vertexStartBuffer;
uvec4 fetchVertexStart(uint vertex) { return texelFetch(vertexStartBuffer, int(vertex)); }
#endif
#if TETMARCH_OPAQUE_SHADOWS
uniform usamplerBuffer opaqueShadowBuffer; // of each vertex; a bit a light
uint fetchOpaqueShadows(uint vertex) { return texelFetch(opaqueShadowBuffer, int(vertex)).x; }
#endif
