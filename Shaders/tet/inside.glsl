// Rays that begin inside of the mesh: the tetrahedron around their origin tells the way on.

// In the place of a boundary face's number: the ray was in the mesh already.
CONSTANT int INSIDE_FACE = 0x7fffffff;

// How much light comes to a point inside of a tetrahedron through the volume, over that distance in that direction
// (unit length): the transmittance. Where rounding puts the point outside, one nearer the centre stands for it.
real transmittanceTowards(Tet tet, vec3 point, vec3 direction, real distance)
{
  vec4 a = fetchVertex(tet.a);
  vec4 b = fetchVertex(tet.b);
  vec4 c = fetchVertex(tet.c);
  vec4 d = fetchVertex(tet.d);
  vec4 sum = a + b + c + d;
  vec3 centre = vec3(sum.x, sum.y, sum.z) * real(0.25);
  Ray ray;
  Traversal traversal;
  traversal.inside = true;
  real pull = real(0);
  do
  {
    ray = rayThrough(point + (centre - point) * pull, direction);
    traversal.entered = entersTet(ray, tet, traversal.face, traversal.link);
    pull = pull + real(0.25);
  } while (!traversal.entered && pull <= real(1));
  real begin = dot(point - ray.origin, ray.direction);
  traversal.entry.depth = begin;
  traversal.entry.face = traversal.entered ? INSIDE_FACE : -1;
  return transmittanceOn(ray, thicknessPerDepthAlong(direction), begin, begin + distance, traversal);
}
