// The picked point of each pixel's ray. Pixels without one are discarded.
#define TETMARCH_PICKED 1
#include "language.glsl"
#include "passes/helper.glsl"

//VTK::Output::Dec

#include "march/volume_buffers.glsl"
#include "tables/table_buffers.glsl"
#include "march/thickness_buffers.glsl"
#if !TETMARCH_COMPOSITE
#include "gather/blend_buffers.glsl"
#endif
#if TETMARCH_EFFECTS
#include "light/effect_buffer_files.glsl"
#endif
#if TETMARCH_CLIPPED
#include "cuts/clipping_buffers.glsl"
#endif
#include "march/march_files.glsl"
#if TETMARCH_KNOWN_AT_END
#include "march/ray_cast.glsl"
#endif
#include "march/pick.glsl"
#if TETMARCH_CLIPPED
#include "cuts/clipping.glsl"
#endif
#include "passes/pixel_ray.glsl"
#include "passes/fragment_ray.glsl"

uniform float transmittanceLeft; // of the ray at the picked point, 0..1

void main()
{
  PixelRay pixel = seenPixelRay();
  float thicknessPerDepth = thicknessPerDepthAlong(pixel.ray.direction);
  Pick pick =
    pickOn(pixel.ray, thicknessPerDepth, pixel.depthBegin, pixel.depthEnd, transmittanceLeft);
  if (!pick.hit)
  {
    discard;
  }
  // A float represents 24 bits of an integer.
  gl_FragData[0] = vec4(float(pick.cell & 0xffffu), float(pick.cell >> 16u), pick.scalar, 1.0);
  gl_FragData[1] = vec4(pixel.ray.origin + pixel.ray.direction * pick.depth, 0.0);
}
