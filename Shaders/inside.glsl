// Rays that begin inside of the mesh: the tetrahedron around their origin tells the way on.

#include "tet.glsl"

// In the place of a boundary face's number: the ray was in the mesh already.
CONSTANT int INSIDE_FACE = 0x7fffffff;

// The face by which the line of the ray comes into the tetrahedron, and its link. Of four real points, a line comes in
// by one face or by none; by none if rounding leaves the origin outside.
bool entersTet(Ray ray, Tet tet, OUT(Crossing) face, OUT(uvec2) link)
{
  bool entered = false;
  int i = 0;
  do
  {
    // (a, b, c | d), (a, d, b | c), (b, d, c | a), (c, d, a | b)
    uvec3 ids = uvec3(i == 2 ? tet.b : (i == 3 ? tet.c : tet.a), i == 0 ? tet.b : tet.d,
      i == 1 ? tet.b : (i == 3 ? tet.a : tet.c));
    link = uvec2(tet.number, i == 0 ? tet.d : (i == 1 ? tet.c : (i == 2 ? tet.a : tet.b)));
    entered = entersFace(ray, ids, face);
    i = i + 1;
  } while (!entered && i < 4);
  return entered;
}

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
#if TETMARCH_BVH
  way.entry.depth = begin;
  way.entry.face = INSIDE_FACE;
#endif
  March march = beginMarch(begin);
  if (way.entered)
  {
    marchOn(ray, opticalLengthOf(direction), begin + distance, way, march);
  }
  return march.radiance.transmittance;
}
