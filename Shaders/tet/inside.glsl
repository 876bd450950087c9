// Rays that begin inside the mesh: they start in the tetrahedron around their origin, not at a boundary face.

// Used in place of a boundary face's index if a ray begins inside the mesh.
CONSTANT int INSIDE_FACE = 0x7fffffff;

// The transmittance from a point in a tetrahedron over a distance in a direction (unit length). If the point is outside
// by rounding, one nearer to the centre is used.
real transmittanceTo(LightStart start, vec3 direction, real distance)
{
  Tet tet = tetBehind(start.side, start.ids);
  vec3 point = start.point;
  vec4 a = fetchVertex(tet.a);
  vec4 b = fetchVertex(tet.b);
  vec4 c = fetchVertex(tet.c);
  vec4 d = fetchVertex(tet.d);
  vec4 sum = a + b + c + d;
  vec3 centre = vec3(sum.x, sum.y, sum.z) * real(0.25);
  Ray ray;
  Traversal traversal;
  traversal.inside = true;
  traversal.entered = false;
  int pulled = 0; // quarters of the way to the centre
  while (!traversal.entered && pulled <= 4)
  {
    ray = rayThrough(point + (centre - point) * (real(0.25) * real(pulled)), direction);
    traversal.entered = entersTet(ray, tet, traversal.place);
    pulled = pulled + 1;
  }
  real begin = dot(point - ray.origin, ray.direction);
  traversal.entry.depth = begin;
  traversal.entry.face = traversal.entered ? INSIDE_FACE : -1;
  vec2 range = lightRange(ray, begin, distance);
  return transmittanceOn(ray, thicknessPerDepthAlong(direction), range.x, range.y, traversal);
}
