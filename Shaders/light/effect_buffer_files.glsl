// The buffers of gradients and light.
#include "light/gradient_buffers.glsl"
#if TETMARCH_SHADING
#include "light/light_buffers.glsl"
#endif
#if TETMARCH_VERTEX_LIGHT && TETMARCH_STRUCTURED
#include "structured/light_node_buffers.glsl"
#endif
#if TETMARCH_VERTEX_LIGHT
#include "light/vertex_light_buffers.glsl"
#endif
