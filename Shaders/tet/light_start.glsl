// Where rays towards the light start: from a point in a tetrahedron.
struct LightStart
{
  Tet tet;
  vec3 point;
};

#if TETMARCH_SAMPLED_SHADOWS
// In the tetrahedron behind a face; the point is yet to be set.
LightStart startIn(Place place)
{
  LightStart start;
  start.tet.number = place.link.x;
  start.tet.a = place.face.id.x;
  start.tet.b = place.face.id.y;
  start.tet.c = place.face.id.z;
  start.tet.d = place.link.y;
  start.point = vec3(real(0), real(0), real(0));
  return start;
}
#endif
