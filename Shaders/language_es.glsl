// What GLSL ES 3.00 (WebGL 2) lacks. It has no texture buffers: an array is a texture with rows of 1 << BUFFER_ROW_SHIFT
// texels. Web/programs.js defines this number by the maximum width of a texture. It has no `precise` and
// no fused multiply-add: the predicate is the one in integers (tet/edge_sign.glsl).
#define precise
#define samplerBuffer sampler2D
#define usamplerBuffer usampler2D
#define BUFFER_TEXEL(buffer, i) texelFetch(buffer, bufferPlace(i), 0)

ivec2 bufferPlace(int i) { return ivec2(i & ((1 << BUFFER_ROW_SHIFT) - 1), i >> BUFFER_ROW_SHIFT); }
