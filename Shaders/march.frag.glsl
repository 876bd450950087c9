// The picture: one ray a pixel.
#include "language.glsl"

//VTK::Output::Dec

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
#include "march_files.glsl"
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

void main()
{
  PixelRay pixel = pixelRay();
  float opticalLength = length(lengthMatrix * pixel.ray.direction);
#if TETMARCH_SAMPLED_SHADOWS
  float jitter = texelFetch(jitterTexture, pixel.at & 63, 0).x;
  March march =
    castSampledRay(pixel.ray, pixel.firstFace, opticalLength, pixel.depthBegin, pixel.depthEnd, jitter);
#else
  March march = castRay(pixel.ray, pixel.firstFace, opticalLength, pixel.depthBegin, pixel.depthEnd);
#endif

  gl_FragData[0] = pixelOf(march.radiance, opticalLength);
#if TETMARCH_DIAGNOSTICS
  // A ray that ends before the mesh, or begins behind it, has looked at a tetrahedron and met none.
  bool met = march.done > pixel.depthBegin;
  gl_FragData[1] = vec4(met ? float(march.cells) : 0.0, float(march.evaluations), errorBound(march.radiance), 0.0);
  gl_FragData[2] = vec4(float(march.refused), float(march.lost), float(march.guarded), 0.0);
#endif
}
