// A ray, and the projection of vertices along it, or its way through a lattice.

struct Ray
{
  vec3 origin; // the point of the ray nearest to the volume's centre, which is the origin of coordinates
#if TETMARCH_STRUCTURED
  vec3 start;    // the origin in lattice coordinates
  vec3 slope;    // lattice coordinates a unit of depth
  vec3 perSlope; // 1 over that; 0 along an axis that the ray runs across
  ivec3 steps;   // 1 or -1: the direction along each axis; 0 across it
#else
  vec3 right;  // right, up, -direction: an orthonormal basis, as the viewer sees it
  vec3 up;
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

#if !TETMARCH_STRUCTURED
// Position on the picture plane of the ray in xy, depth along the ray in z. Every vertex is projected by this function,
// so that it gets the same bits each time.
vec3 project(Ray ray, vec3 vertex)
{
  precise real x = vertex.x - ray.origin.x;
  precise real y = vertex.y - ray.origin.y;
  precise real z = vertex.z - ray.origin.z;
  precise real right = x * ray.right.x + y * ray.right.y + z * ray.right.z;
  precise real up = x * ray.up.x + y * ray.up.y + z * ray.up.z;
  precise real depth = x * ray.direction.x + y * ray.direction.y + z * ray.direction.z;
  vec2 p = snapToPredicate(vec2(right, up));
  return vec3(p.x, p.y, depth);
}
#endif

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
int stepAlong(real slope) { return abs(slope) > TINY ? (slope > real(0) ? 1 : -1) : 0; }
real perSlopeOf(real slope) { return abs(slope) > TINY ? real(1) / slope : real(0); }

void orient(INOUT(Ray) ray)
{
  ray.start = toLattice(ray.origin);
  ray.slope = directionToLattice(ray.direction);
  ray.perSlope = vec3(perSlopeOf(ray.slope.x), perSlopeOf(ray.slope.y), perSlopeOf(ray.slope.z));
  ray.steps = ivec3(stepAlong(ray.slope.x), stepAlong(ray.slope.y), stepAlong(ray.slope.z));
}
#else
// The axis along which the direction is least gives the best angle.
void orient(INOUT(Ray) ray)
{
  vec3 direction = ray.direction;
  vec3 size = vec3(abs(direction.x), abs(direction.y), abs(direction.z));
  vec3 axis = size.x <= size.y && size.x <= size.z ? vec3(real(1), real(0), real(0))
    : (size.y <= size.z ? vec3(real(0), real(1), real(0)) : vec3(real(0), real(0), real(1)));
  ray.right = normalize(cross(direction, axis));
  ray.up = cross(ray.right, direction);
}
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
