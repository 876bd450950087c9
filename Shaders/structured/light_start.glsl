// The starting point of rays towards the light: the planes determine the cell.
struct LightStart
{
  vec3 point;
};

#if TETMARCH_SAMPLED_SHADOWS
// The point must be set.
LightStart startIn(RayPosition place)
{
  LightStart start;
  start.point = vec3(real(0), real(0), real(0));
  return start;
}
#endif
