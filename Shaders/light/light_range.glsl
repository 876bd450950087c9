// Rays of the CPU's light at vertices have included it.
#if TETMARCH_LIGHT_THROUGH_CUTS && !TETMARCH_LIGHT_RAYS
#include "cuts/clipping.glsl"
#endif

// The depths between which the volume absorbs light on a ray from a point towards the light.
vec2 lightRange(Ray ray, real begin, real distance)
{
  vec2 range = vec2(begin, begin + distance);
#if TETMARCH_LIGHT_THROUGH_CUTS
  range = clippedRange(ray, range);
  range = range.x < range.y ? range : vec2(begin, begin);
#endif
  return range;
}
