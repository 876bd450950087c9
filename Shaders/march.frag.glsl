// The picture: one ray a pixel.
#include "language.glsl"
#include "helper.glsl"

//VTK::Output::Dec
#if TETMARCH_PEELED
//VTK::DepthPeeling::Dec
#endif

#include "mesh_buffers.glsl"
#include "table_buffers.glsl"
#if !TETMARCH_COMPOSITE
#include "blend_buffers.glsl"
#endif
#if TETMARCH_EFFECTS
#include "effect_buffers.glsl"
#endif
#if TETMARCH_SAMPLED_SHADOWS
#include "light_buffers.glsl"
#endif
#if TETMARCH_CLIPPED
#include "clipping_buffers.glsl"
#endif
#include "march_files.glsl"
#if TETMARCH_CLIPPED
#include "clipping.glsl"
#endif
#include "pixel_ray.glsl"
#if TETMARCH_SAMPLED_SHADOWS
#include "light_ray_files.glsl"
#include "sampled_shadows.glsl"
#else
#include "ray_cast.glsl"
#endif

#if TETMARCH_SAMPLED_SHADOWS
uniform sampler2D jitterTexture; // a tile of 64 x 64 pixels, Optics/BlueNoise.h
#else
uniform mat3 lengthMatrix; // direction -> world, in scalar opacity unit distances
#endif

float pixelLength(PixelRay pixel) { return length(lengthMatrix * pixel.ray.direction); }

March marchPixel(PixelRay pixel)
{
  float opticalLength = pixelLength(pixel);
#if TETMARCH_SAMPLED_SHADOWS
  float jitter = texelFetch(jitterTexture, pixel.at & 63, 0).x;
  return castSampledRay(pixel.ray, pixel.firstFace, opticalLength, pixel.depthBegin, pixel.depthEnd, jitter);
#else
  return castPlainRay(pixel.ray, pixel.firstFace, opticalLength, pixel.depthBegin, pixel.depthEnd);
#endif
}

vec4 colorOf(PixelRay pixel, March march) { return pixelOf(march.radiance, pixelLength(pixel)); }

#if TETMARCH_PEELED
#include "peeled_main.glsl"
#else
void main()
{
  PixelRay pixel = pixelRay();
  March march = marchPixel(pixel);
  gl_FragData[0] = colorOf(pixel, march);
#if TETMARCH_DIAGNOSTICS
  // A ray that ends before the mesh, or begins behind it, has looked at a tetrahedron and met none.
  bool met = march.done > pixel.depthBegin;
  gl_FragData[1] = vec4(met ? float(march.cells) : 0.0, float(march.evaluations), errorBound(march.radiance), 0.0);
  gl_FragData[2] = vec4(float(march.refused), float(march.lost), float(march.guarded), 0.0);
#endif
}
#endif
