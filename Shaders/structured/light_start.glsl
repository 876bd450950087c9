// Where rays towards the light start: the planes tell in which cell.
struct LightStart
{
  vec3 point;
};

#if TETMARCH_SAMPLED_SHADOWS
// The point is yet to be set.
LightStart startIn(Place place)
{
  LightStart start;
  start.point = vec3(real(0), real(0), real(0));
  return start;
}
#endif
