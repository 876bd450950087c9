// The march of one pixel's ray, and its colour. Called by a fragment shader (march.frag.glsl) or a compute shader
// (march.comp.glsl).

#include "march/volume_buffers.glsl"
#include "tables/table_buffers.glsl"
#include "march/thickness_buffers.glsl"
#if TETMARCH_CURVED_ERROR
#include "gather/curved_error_buffers.glsl"
#endif
#if !TETMARCH_COMPOSITE
#include "gather/blend_buffers.glsl"
#endif
#if TETMARCH_EFFECTS
#include "light/effect_buffer_files.glsl"
#elif TETMARCH_LIT_COMPONENTS
#if TETMARCH_COMPONENT_GRADIENTS
#include "light/gradient_buffers.glsl"
#endif
#include "light/light_buffers.glsl"
#endif
#if TETMARCH_SAMPLED_SHADOWS
#include "light/light_ray_buffers.glsl"
#endif
#if TETMARCH_CLIPPED
#include "cuts/clipping_buffers.glsl"
#endif
#include "march/march_files.glsl"
#if TETMARCH_CLIPPED
#include "cuts/clipping.glsl"
#endif
#include "passes/pixel_ray.glsl"
#if !TETMARCH_DIAGNOSTICS
#include "passes/color_window.glsl"
#endif
#if TETMARCH_SAMPLED_SHADOWS
#include "light/light_ray_files.glsl"
#include "light/light_samples.glsl"
#if TETMARCH_LIGHT_TOLERANCE
#include "light/sampled_shadows_adaptive.glsl"
#else
#include "light/sampled_shadows_even.glsl"
#endif
#include "light/sampled_ray.glsl"
#else
#include "march/ray_cast.glsl"
#endif

#if TETMARCH_SAMPLED_SHADOWS || TETMARCH_POINT_SAMPLED
uniform sampler2D jitterTexture; // a tile of 64 x 64 pixels, View/BlueNoise.h
#endif

March marchPixel(PixelRay pixel)
{
  float thicknessPerDepth = thicknessPerDepthAlong(pixel.ray.direction);
#if TETMARCH_POINT_SAMPLED
  shiftSamples(texelFetch(jitterTexture, pixel.at & 63, 0).x * sampleShift.x + sampleShift.y, pixel.ray);
#endif
#if TETMARCH_SAMPLED_SHADOWS
  float jitter = texelFetch(jitterTexture, pixel.at & 63, 0).x;
  return castSampledRay(pixel.ray, thicknessPerDepth, pixel.depthBegin, pixel.depthEnd, jitter);
#else
  return castPlainRay(pixel.ray, thicknessPerDepth, pixel.depthBegin, pixel.depthEnd);
#endif
}

vec4 colorOf(PixelRay pixel, March march)
{
  vec4 color = pixelOf(march.radiance, thicknessPerDepthAlong(pixel.ray.direction));
#if TETMARCH_DIAGNOSTICS
  return color;
#else
  return windowed(color);
#endif
}

#if TETMARCH_DIAGNOSTICS
// A ray that ends before the mesh, or begins behind it, may have crossed a tetrahedron without gathering it.
vec4 measuresOf(PixelRay pixel, March march)
{
  bool met = march.done > pixel.depthBegin;
  return vec4(met ? float(march.cells) : 0.0, float(march.lookups), errorBound(march.radiance), 0.0);
}

vec4 troubleOf(March march) { return vec4(float(march.refused), float(march.lost), float(march.guarded), 0.0); }
#endif
