// The projection of vertices along a ray.

// Sets the picture plane by the direction. The axis of its smallest component gives the best angle.
void orient(INOUT(Ray) ray)
{
  vec3 direction = ray.direction;
  vec3 size = vec3(abs(direction.x), abs(direction.y), abs(direction.z));
  vec3 axis = size.x <= size.y && size.x <= size.z ? vec3(real(1), real(0), real(0))
    : (size.y <= size.z ? vec3(real(0), real(1), real(0)) : vec3(real(0), real(0), real(1)));
  ray.right = normalize(cross(direction, axis));
  ray.up = cross(ray.right, direction);
}

// Position on the picture plane of the ray in xy, depth along the ray in z. Every vertex is projected by this function,
// so that it gets the same bits each time; passes/predicate_check.frag.glsl checks that.
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
