// A ray.

struct Ray
{
  vec3 origin; // the point of the ray nearest to the volume's centre, the origin of coordinates
#if TETMARCH_STRUCTURED
  vec3 start;    // the origin in lattice coordinates
  vec3 slope;    // lattice coordinates per unit of depth
  vec3 perSlope; // reciprocal of slope; 0 along an axis perpendicular to the ray
  vec3 never;    // 1 along an axis perpendicular to the ray, else 0
  ivec3 steps;   // 1 or -1: the direction along each axis; 0 if perpendicular
#if TETMARCH_POINT_SAMPLED
  real firstSample; // depth; structured/ray_samples.glsl
#endif
#else
  vec3 right;  // right, up, -direction: an orthonormal basis, as the viewer sees it
  vec3 up;
#if TETMARCH_ENTRY_LISTS
  int firstCandidate;  // range of the faces through which the ray of a pixel may enter:
  int endOfCandidates; // [firstCandidate, endOfCandidates)
  uint pixelInTile;    // x and y, 4 bits each
#endif
#endif
  vec3 direction; // unit length
#if TETMARCH_SHADING
  vec3 toEye; // unit length, in the coordinates of the lights
#endif
#if TETMARCH_CROPPED
  vec3 lowDepth; // depths of the crossings with the planes of the cropping
  vec3 highDepth;
#endif
};

#if TETMARCH_CROPPED
// Depth at which a ray has moved that distance along an axis; NO_DEPTH if it is perpendicular.
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

// The ray through a point. For any distance of the eye, the error of the origin q - dir (q.dir) is a few 1e-7 radii of
// the volume; that of eye + dir t would be as much of the eye's distance.
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
