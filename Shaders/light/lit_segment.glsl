// A subsegment in light.

// What it emits. Light from the eye is absorbed as much before it gets to a point as what is reflected is behind: by
// the ray's transmittance. Of all that is seen of the subsegment, 1 - absorbed / 2 of that light is left on the average.
vec3 litEmission(vec4 mean, Illumination lit, Radiance radiance, Absorption by)
{
  Light light = lit.direct;
#if TETMARCH_HEADLIGHT_SHADOWS
  real transmittance = radiance.transmittance * (real(1) - real(0.5) * by.absorbed);
  light = addLight(light, dimLight(lit.head, transmittance));
#endif
  return reflection(mean, light);
}

#if TETMARCH_SAMPLED_SHADOWS
// Keeps what the subsegment reflects of the lights whose transmittance the next sample will tell; before absorb().
void keepPending(INOUT(Radiance) radiance, vec4 mean, Illumination lit, Absorption by)
{
  real weight = radiance.transmittance * by.evenly * by.thickness;
  radiance.pendingA = radiance.pendingA + reflection(mean, lit.beamA) * weight;
#if TETMARCH_SEVERAL_SHADOWS
  radiance.pendingB = radiance.pendingB + reflection(mean, lit.beamB) * weight;
  radiance.pendingC = radiance.pendingC + reflection(mean, lit.beamC) * weight;
#endif
}
#endif

#if TETMARCH_ERROR_BOUND || TETMARCH_LIGHT_ERROR
real greatest(vec3 v) { return max(abs(v.x), max(abs(v.y), abs(v.z))); }
#endif

#if TETMARCH_ERROR_BOUND || TETMARCH_TABLE_ERROR
// How bright a colour of 1 can become.
real brightness(Illumination lit)
{
  real bright = greatest(lit.direct.diffuse);
#if TETMARCH_HEADLIGHT_SHADOWS
  bright = bright + greatest(lit.head.diffuse);
#endif
#if TETMARCH_SAMPLED_SHADOWS
  bright = bright + greatest(lit.beamA.diffuse);
#if TETMARCH_SEVERAL_SHADOWS
  bright = bright + greatest(lit.beamB.diffuse) + greatest(lit.beamC.diffuse);
#endif
#endif
  return bright;
}
#endif
