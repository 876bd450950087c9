// The picture: one ray a pixel.
#include "language.glsl"

//VTK::Output::Dec

#include "mesh_buffers.glsl"
#include "table_buffers.glsl"
#include "edge_sign.glsl"
#include "ray.glsl"
#include "crossing.glsl"
#include "boundary.glsl"
#include "integral_table.glsl"
#include "radiance.glsl"
#if TETMARCH_POINT_SCALARS
#include "segment_adaptive.glsl"
#else
#include "segment_constant.glsl"
#endif
#include "march.glsl"
#include "ray_cast.glsl"

uniform vec4 viewport;  // x, y, width, height in pixels
uniform vec4 eye;       // (position, 1) or, for parallel projection, (direction towards it, 0)
uniform mat3 lengthMatrix; // direction -> world, in scalar opacity unit distances

#if TETMARCH_RASTER_ENTRY
uniform sampler2D entryTexture;
#endif
#if TETMARCH_OPAQUE_DEPTH
uniform sampler2D opaqueDepthTexture;
uniform bool cutsFarPlane;
#endif
#if TETMARCH_OPAQUE_DEPTH || !TETMARCH_RASTER_ENTRY
uniform mat4 clipToNormalized;

vec3 unproject(vec2 pixel, float windowDepth)
{
  vec4 p = clipToNormalized * vec4(vec3((pixel - viewport.xy) / viewport.zw, windowDepth) * 2.0 - 1.0, 1.0);
  return p.xyz / p.w;
}
#endif

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - viewport.xy);
  float depthBegin = -NO_DEPTH;
  float depthEnd = NO_DEPTH;

#if TETMARCH_RASTER_ENTRY
  // The ray through the interpolated position, kept a little inside the face, is sure to hit it: rounding
  // in the rasteriser moves rays, by less than 0.01 pixels, but doesn't lose them.
  vec4 entry = texelFetch(entryTexture, pixel, 0);
  if (entry.x < 0.0)
  {
    discard;
  }
  int firstFace = int(entry.x);
  vec3 share = max(entry.yzw, vec3(1e-4));
  share /= share.x + share.y + share.z;
  uvec3 ids = fetchBoundaryFace(uint(firstFace));
  vec3 point = share.x * fetchVertex(ids.x).xyz + share.y * fetchVertex(ids.y).xyz +
    share.z * fetchVertex(ids.z).xyz;
#else
  int firstFace = -1;
  vec3 point = unproject(gl_FragCoord.xy, 0.0);
#endif

  Ray ray = rayThrough(point, normalize(point * eye.w - eye.xyz));
#if !TETMARCH_RASTER_ENTRY
  depthBegin = dot(point - ray.origin, ray.direction);
#endif
#if TETMARCH_OPAQUE_DEPTH
  // Of a far plane that is a million times as far as the near plane no digit is left.
  float windowDepth = texelFetch(opaqueDepthTexture, pixel, 0).x;
  if (windowDepth < 1.0 || cutsFarPlane)
  {
    depthEnd = dot(unproject(gl_FragCoord.xy, windowDepth) - ray.origin, ray.direction);
  }
#endif

  March march = castRay(ray, firstFace, length(lengthMatrix * ray.direction), depthBegin, depthEnd);

  gl_FragData[0] = vec4(march.radiance.color, 1.0 - march.radiance.transmittance);
#if TETMARCH_DIAGNOSTICS
  gl_FragData[1] = vec4(float(march.cells), float(march.evaluations), 0.0, 0.0);
  gl_FragData[2] = vec4(float(march.refused), float(march.lost), float(march.guarded), 0.0);
#endif
}
