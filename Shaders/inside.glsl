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
  Way way;
  way.inside = true;
  real pull = real(0);
  do
  {
    ray = rayThrough(point + (centre - point) * pull, direction);
    way.entered = entersTet(ray, tet, way.face, way.link);
    pull = pull + real(0.25);
  } while (!way.entered && pull <= real(1));
  real begin = dot(point - ray.origin, ray.direction);
  way.entry.depth = begin;
  way.entry.face = way.entered ? INSIDE_FACE : -1;
  return transmittanceOn(ray, opticalLengthOf(direction), begin, begin + distance, way);
}
