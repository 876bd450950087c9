// The ray of a pixel, and its visible part.

uniform vec4 viewport;  // x, y, width, height in pixels
uniform vec4 eye;       // (position, 1) or, for parallel projection, (direction towards it, 0)
uniform mat4 rayPoints; // View/RayPoints.h

#if !TETMARCH_ENTRY_LISTS || TETMARCH_VISIBLE_PART
uniform vec4 nearPlane; // at which rays begin, or 0: View.h
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

// Depth along a pixel's ray of its point at a window depth. If the far plane is a million times as far as the near
// plane, its depth has no correct digit, and cutsFarPlane is false.
float depthAt(vec2 center, Ray ray, float windowDepth)
{
  return windowDepth < 1.0 || cutsFarPlane ? dot(unproject(center, windowDepth) - ray.origin, ray.direction) : NO_DEPTH;
}
#endif

struct PixelRay
{
  vec2 center;      // of the pixel, in pixels of the window
  ivec2 at;         // pixel, from the corner of the viewport
  Ray ray;
  float depthBegin; // the visible part is from here to depthEnd
  float depthEnd;
  bool seen;        // the ray neither misses the mesh nor is clipped
};

vec3 rayPoint(vec2 center)
{
  vec2 xy = (center - viewport.xy) / viewport.zw * 2.0 - 1.0;
  vec4 p = rayPoints * vec4(xy, 0.0, 1.0);
  return p.xyz / p.w;
}

// Without branches around the following code, which would cost a GPU registers.
PixelRay pixelRay(vec2 center)
{
  PixelRay found;
  ivec2 pixel = ivec2(center - viewport.xy);
  found.center = center;
  found.at = pixel;
  found.depthBegin = -NO_DEPTH;
  found.depthEnd = NO_DEPTH;
  found.seen = true;

  vec3 point = rayPoint(center);
  Ray ray = rayThrough(point, normalize(point * eye.w - eye.xyz));
#if TETMARCH_ENTRY_LISTS
  ivec2 candidates = fetchCandidateRange(pixel);
  found.seen = candidates.x < candidates.y;
  ray.firstCandidate = candidates.x;
  ray.endOfCandidates = candidates.y;
  ray.pixelInTile = pixelInTile(pixel);
#endif
#if !TETMARCH_ENTRY_LISTS || TETMARCH_VISIBLE_PART
  float perDepth = dot(nearPlane.xyz, ray.direction);
  found.depthBegin = perDepth > 0.0 ? -(dot(nearPlane.xyz, ray.origin) + nearPlane.w) / perDepth : -NO_DEPTH;
#endif
#if TETMARCH_OPAQUE_DEPTH
  ivec2 depth = ivec2((vec2(pixel) + 0.5) * depthsPerPixel);
  found.depthEnd = depthAt(center, ray, texelFetch(opaqueDepthTexture, depth, 0).x);
#endif
#if TETMARCH_CLIPPED
  vec2 left = clippedRange(ray, vec2(found.depthBegin, found.depthEnd));
  found.seen = found.seen && left.x < left.y;
  found.depthBegin = left.x;
  found.depthEnd = left.y;
#endif
#if TETMARCH_POINT_SAMPLED
  placeSamples(found.depthBegin, ray);
#endif
  found.ray = ray;
  return found;
}
