// Of each coarse sample (passes/ray_list.glsl): its first ray in the list, and the bits of its rays. The pyramid is
// searched here, once for three pixels, and not where they are merged: its loop takes llvmpipe 30 ns.
//VTK::Output::Dec

#include "passes/sample_grid.glsl"
#include "passes/ray_list.glsl"

void main()
{
  ivec2 coarse = ivec2(gl_FragCoord.xy);
  gl_FragData[0] = vec4(float(firstRayOf(coarse)), texelFetch(newRayTexture, coarse, 0).x, 0.0, 0.0);
}
