// The ray of a pixel, the face by which it enters the mesh according to the rasteriser, and the part of it that is seen.

uniform vec4 viewport; // x, y, width, height in pixels
uniform vec4 eye;      // (position, 1) or, for parallel projection, (direction towards it, 0)

#if TETMARCH_RASTER_ENTRY
uniform sampler2D entryTexture;
#else
uniform bool cutsNearPlane; // rays begin at the near plane
#endif
#if TETMARCH_OPAQUE_DEPTH
uniform sampler2D opaqueDepthTexture;
uniform vec2 depthsPerPixel; // 1, or more if there are fewer rays than pixels
#endif
#if TETMARCH_OPAQUE_DEPTH || TETMARCH_PEELED
uniform bool cutsFarPlane;
uniform mat4 clipToNormalized;

vec3 unproject(vec2 pixel, float windowDepth)
{
  vec4 p = clipToNormalized * vec4(vec3((pixel - viewport.xy) / viewport.zw, windowDepth) * 2.0 - 1.0, 1.0);
  return p.xyz / p.w;
}

// Depth along a pixel's ray of its point at a depth of the window. If the far plane is a million times as far as the
// near plane, its depth has no correct digit, and cutsFarPlane is false.
float depthAt(Ray ray, float windowDepth)
{
  return windowDepth < 1.0 || cutsFarPlane
    ? dot(unproject(gl_FragCoord.xy, windowDepth) - ray.origin, ray.direction)
    : NO_DEPTH;
}
#endif

struct PixelRay
{
  ivec2 at;         // pixel, from the corner of the viewport
  Ray ray;
  int firstFace;    // by the rasteriser; -1: a search finds it
  float depthBegin; // the part from here to depthEnd is seen
  float depthEnd;
};

#if TETMARCH_RAY_POINTS
uniform mat4 rayPoints; // Rays/RayPoints.h

vec3 rayPoint()
{
  vec2 xy = (gl_FragCoord.xy - viewport.xy) / viewport.zw * 2.0 - 1.0;
  vec4 p = rayPoints * vec4(xy, 0.0, 1.0);
  return p.xyz / p.w;
}
#endif

#if TETMARCH_RASTER_ENTRY
// Barycentrics none of which is less than the given one: what those below lack is taken from the greatest.
vec3 insideFace(vec3 barycentrics, float least)
{
  vec3 inside = max(barycentrics, vec3(least));
  float excess = inside.x + inside.y + inside.z - 1.0;
  inside -= excess * vec3(equal(inside, vec3(max(inside.x, max(inside.y, inside.z)))));
  inside = max(inside, vec3(least));
  return inside / (inside.x + inside.y + inside.z);
}

#if TETMARCH_BVH
bool isBesideEntry(ivec2 pixel)
{
  ivec2 last = ivec2(viewport.zw) - 1;
  float most = max(max(texelFetch(entryTexture, max(pixel - ivec2(1, 0), ivec2(0)), 0).x,
                     texelFetch(entryTexture, min(pixel + ivec2(1, 0), last), 0).x),
    max(texelFetch(entryTexture, max(pixel - ivec2(0, 1), ivec2(0)), 0).x,
      texelFetch(entryTexture, min(pixel + ivec2(0, 1), last), 0).x));
  return most >= 0.0;
}
#endif
#endif

// Discards helpers, pixels beside the mesh, and pixels whose ray is clipped away.
PixelRay pixelRay()
{
  PixelRay found;
  ivec2 pixel = ivec2(gl_FragCoord.xy - viewport.xy);
  found.at = pixel;
  found.depthBegin = -NO_DEPTH;
  found.depthEnd = NO_DEPTH;

#if TETMARCH_RASTER_ENTRY
  // The ray through the interpolated point keeps its digits however far away the eye is. In a few pixels of a hundred
  // thousand, rounding makes the rasteriser name a face beside the one by which the ray enters.
  vec4 entry = texelFetch(entryTexture, pixel, 0);
  int firstFace = int(entry.x);
#if TETMARCH_BVH
  // A search finds the entry then; also where the rasteriser missed a needle and left a hole, and where it extrapolates
  // beyond a needle that it sees edge-on.
  if (IS_HELPER || (firstFace < 0 && !isBesideEntry(pixel)))
  {
    discard;
  }
#else
  if (IS_HELPER || firstFace < 0)
  {
    discard;
  }
#endif
  uvec3 ids = fetchBoundaryFace(uint(max(firstFace, 0)));
  vec3 a = fetchVertex(ids.x).xyz;
  vec3 b = fetchVertex(ids.y).xyz;
  vec3 c = fetchVertex(ids.z).xyz;
  Ray ray;
#if TETMARCH_BVH
  vec3 w = entry.yzw; // barycentrics
  bool known = firstFace >= 0 && max(abs(w.x), max(abs(w.y), abs(w.z))) < 8.0;
  vec3 point = known ? w.x * a + w.y * b + w.z * c : rayPoint();
  ray = rayThrough(point, normalize(point * eye.w - eye.xyz));
#else
  // The ray is moved a little into the face, so that it does not run through a vertex: there it could leave the mesh at
  // once, between faces that ties bend outwards, and enter again. It is moved farther if the face is so small that
  // rounding refuses the ray.
  bool refused = false;
  float least = 1e-4;
  do
  {
    vec3 w = insideFace(entry.yzw, least);
    vec3 point = w.x * a + w.y * b + w.z * c;
    ray = rayThrough(point, normalize(point * eye.w - eye.xyz));
    FaceIntersection intersection;
    refused = !enters(ray, uint(firstFace), intersection);
    least *= 32.0;
  } while (refused && least < 1e5);
#endif
#else
  if (IS_HELPER)
  {
    discard;
  }
  int firstFace = -1;
  vec3 point = rayPoint();
  Ray ray = rayThrough(point, normalize(point * eye.w - eye.xyz));
  if (cutsNearPlane)
  {
    found.depthBegin = dot(point - ray.origin, ray.direction);
  }
#endif
#if TETMARCH_OPAQUE_DEPTH
  ivec2 depth = ivec2((vec2(pixel) + 0.5) * depthsPerPixel);
  found.depthEnd = depthAt(ray, texelFetch(opaqueDepthTexture, depth, 0).x);
#endif
#if TETMARCH_CLIPPED
  vec2 left = clippedRange(ray, vec2(found.depthBegin, found.depthEnd));
  if (!(left.x < left.y))
  {
    discard;
  }
  found.depthBegin = left.x;
  found.depthEnd = left.y;
#endif
#if TETMARCH_POINT_SAMPLED
  placeSamples(found.depthBegin, ray);
#endif
  found.ray = ray;
  found.firstFace = firstFace;
  return found;
}
