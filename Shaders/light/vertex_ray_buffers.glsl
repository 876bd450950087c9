// Uniforms of rays from vertices, besides light/light_ray_buffers.glsl; bound by GL/EffectTextures.
#if !TETMARCH_STRUCTURED
uniform usamplerBuffer vertexStartBuffer;
uvec4 fetchVertexStart(uint vertex) { return BUFFER_TEXEL(vertexStartBuffer, int(vertex)); }
#endif
#if TETMARCH_OPAQUE_SHADOWS
uniform usamplerBuffer opaqueShadowBuffer; // per vertex; one bit per light
uint fetchOpaqueShadows(uint vertex) { return BUFFER_TEXEL(opaqueShadowBuffer, int(vertex)).x; }
#endif
