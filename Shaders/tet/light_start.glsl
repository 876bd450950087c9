// The starting point of rays towards the light, in a tetrahedron.
struct LightStart
{
  Side side; // of one of its faces
  uvec3 ids; // three of its vertices, counter-clockwise seen from outside
  vec3 point;
};

#if TETMARCH_SAMPLED_SHADOWS
// The start in the tetrahedron behind a face; the point must be set.
LightStart startIn(RayPosition place)
{
  LightStart start;
  start.side = place.side;
  start.ids = place.face.id;
  start.point = vec3(real(0), real(0), real(0));
  return start;
}
#endif
