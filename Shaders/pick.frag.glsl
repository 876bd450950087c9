// Where the ray of each pixel is picked. Pixels whose ray is not keep what they have.
#include "language.glsl"

//VTK::Output::Dec

#include "mesh_buffers.glsl"
#include "table_buffers.glsl"
#if TETMARCH_EFFECTS
#include "effect_buffers.glsl"
#endif
#if TETMARCH_CLIPPED
#include "clipping_buffers.glsl"
#endif
#include "traversal_files.glsl"
#include "extinction.glsl"
#include "tet.glsl"
#include "pick.glsl"
#if TETMARCH_CLIPPED
#include "clipping.glsl"
#endif
#include "pixel_ray.glsl"

uniform mat3 lengthMatrix; // direction -> world, in scalar opacity unit distances

void main()
{
  PixelRay pixel = pixelRay();
  Way way = wayFromBoundary(pixel.ray, pixel.firstFace);
  float opticalLength = length(lengthMatrix * pixel.ray.direction);
  Pick pick = pickOn(pixel.ray, opticalLength, pixel.depthBegin, pixel.depthEnd, way);
  if (!pick.hit)
  {
    discard;
  }
  // A float holds 24 bits of a number.
  gl_FragData[0] = vec4(float(pick.tet & 0xffffu), float(pick.tet >> 16u), pick.scalar, 1.0);
  gl_FragData[1] = vec4(pixel.ray.origin + pixel.ray.direction * pick.depth, 0.0);
}
