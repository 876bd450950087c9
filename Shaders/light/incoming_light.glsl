// The transmittance from a point towards ambient light, which is the mean over a few directions up to a radius, then
// towards each of up to three lights; 0..1. blocked: a bit for each light that opaque geometry keeps off.
vec4 incomingLight(LightStart start, uint blocked)
{
  vec4 light = vec4(real(1), real(1), real(1), real(1));
  real ambient = real(0);
  for (int k = 0; k < shadowSourceCount + occlusionDirectionCount; ++k)
  {
    bool fromLight = occlusionDirectionCount == 0 || k < shadowSourceCount;
    vec4 source = fetchShadowSource(min(k, MOST_SHADOW_SOURCES - 1)); // position, 1; or unit vector to it, 0
    vec3 toLight = vec3(source.x, source.y, source.z) - start.point * source.w;
    real far = sqrt(dot(toLight, toLight));
    vec3 direction =
      fromLight ? toLight * (real(1) / max(far, TINY))
                : sphereDirection(k - shadowSourceCount, occlusionDirectionCount);
    real distance = fromLight ? min(source.w > real(0) ? far : NO_DEPTH, lightReach) : occlusionRadius;
    // Light that is kept off needs no march.
    distance = fromLight && (blocked >> uint(k) & 1u) != 0u ? real(0) : distance;
    real transmittance = transmittanceTo(start, direction, distance);
    light.y = k == 0 && fromLight ? transmittance : light.y;
    light.z = k == 1 && fromLight ? transmittance : light.z;
    light.w = k == 2 && fromLight ? transmittance : light.w;
    ambient = ambient + (fromLight ? real(0) : transmittance);
  }
  light.x = occlusionDirectionCount > 0 ? ambient / real(occlusionDirectionCount) : real(1);
  light.y = (blocked & 1u) != 0u ? real(0) : light.y;
  light.z = (blocked & 2u) != 0u ? real(0) : light.z;
  light.w = (blocked & 4u) != 0u ? real(0) : light.w;
  return light;
}
