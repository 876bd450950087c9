// Where rays towards the light start: from a point in a tetrahedron.
struct LightStart
{
  Side side; // of one of its faces
  uvec3 ids; // three of its vertices, of a face that turns counter-clockwise seen from outside
  vec3 point;
};

#if TETMARCH_SAMPLED_SHADOWS
// In the tetrahedron behind a face; the point is yet to be set.
LightStart startIn(Place place)
{
  LightStart start;
  start.side = place.side;
  start.ids = place.face.id;
  start.point = vec3(real(0), real(0), real(0));
  return start;
}
#endif
