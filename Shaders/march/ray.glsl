// A ray.

struct Ray
{
  vec3 origin; // the point of the ray nearest to the volume's centre, which is the origin of coordinates
#if TETMARCH_STRUCTURED
  vec3 start;    // the origin in lattice coordinates
  vec3 slope;    // lattice coordinates a unit of depth
  vec3 perSlope; // 1 over that; 0 along an axis that the ray runs across
  vec3 never;    // 1 along an axis that the ray runs across, else 0
  ivec3 steps;   // 1 or -1: the direction along each axis; 0 across it
#if TETMARCH_POINT_SAMPLED
  real firstSample; // depth; structured/ray_samples.glsl
#endif
#else
  vec3 right;  // right, up, -direction: an orthonormal basis, as the viewer sees it
  vec3 up;
#if TETMARCH_ENTRY_LISTS
  int firstCandidate;  // of a ray of a pixel: the faces by which it may enter are those from this one
  int endOfCandidates; // to before that one
  uint pixelInTile;    // x and y, 4 bits each
#endif
#endif
  vec3 direction; // unit length
#if TETMARCH_SHADING
  vec3 toEye; // unit length, in the coordinates of the lights
#endif
#if TETMARCH_CROPPED
  vec3 lowDepth; // depths at which it crosses the planes of the cropping
  vec3 highDepth;
#endif
};

#if TETMARCH_CROPPED
// Depth at which a ray has gone that far along an axis; NO_DEPTH if it runs across it.
real depthAlong(real distance, real slope) { return abs(slope) > TINY ? distance / slope : NO_DEPTH; }

vec3 planeDepths(vec3 planes, vec3 origin, vec3 direction)
{
  vec3 d = planes - origin;
  return vec3(
    depthAlong(d.x, direction.x), depthAlong(d.y, direction.y), depthAlong(d.z, direction.z));
}
#endif

#if TETMARCH_STRUCTURED
#include "structured/ray_steps.glsl"
#else
#include "tet/projection.glsl"
#endif

// The ray through a point. However far away the eye is, the origin q - dir (q.dir) errs by a few 1e-7 radii of the volume;
// eye + dir t would err by as much of the eye's distance.
Ray rayThrough(vec3 point, vec3 direction)
{
  Ray ray;
  ray.direction = direction;
  ray.origin = point - direction * dot(point, direction);
  orient(ray);
#if TETMARCH_SHADING
#if TETMARCH_WORLD_LIGHTS
  ray.toEye = normalize(toWorld(direction * real(-1)));
#else
  ray.toEye = direction * real(-1);
#endif
#endif
#if TETMARCH_CROPPED
  ray.lowDepth = planeDepths(croppingLow, ray.origin, direction);
  ray.highDepth = planeDepths(croppingHigh, ray.origin, direction);
#endif
  return ray;
}
