// A ray, and the projection of vertices along it.

struct Ray
{
  vec3 origin; // the point of the ray nearest to the mesh's centre, which is the origin of coordinates
  vec3 right;  // right, up, -direction: an orthonormal basis, as the viewer sees it
  vec3 up;
  vec3 direction; // unit length
#if TETMARCH_SHADING
  vec3 toEye; // unit length, in the coordinates of the lights
#endif
};

// Position on the picture plane of the ray in xy, depth along the ray in z. Every vertex is projected by
// this function and no other, so that it gets the same bits at every visit.
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

// The ray through a point, which it keeps however far away the eye is: q - dir (q.dir) errs by a few
// 1e-7 mesh radii, eye + dir t by as much of the eye's distance.
Ray rayThrough(vec3 point, vec3 direction)
{
  Ray ray;
  ray.direction = direction;
  ray.origin = point - direction * dot(point, direction);
  // The axis that is least along the direction gives the basis its best angle.
  vec3 size = vec3(abs(direction.x), abs(direction.y), abs(direction.z));
  vec3 axis = size.x <= size.y && size.x <= size.z ? vec3(real(1), real(0), real(0))
    : (size.y <= size.z ? vec3(real(0), real(1), real(0)) : vec3(real(0), real(0), real(1)));
  ray.right = normalize(cross(direction, axis));
  ray.up = cross(ray.right, direction);
#if TETMARCH_SHADING
#if TETMARCH_WORLD_LIGHTS
  ray.toEye = normalize(toWorld(direction * real(-1)));
#else
  ray.toEye = direction * real(-1);
#endif
#endif
  return ray;
}
