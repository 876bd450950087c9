// A piece of the volume in light.

// What it sends out. Light that comes along the ray has been absorbed on its way as much as what comes back will be; of
// all that is seen of the piece, 1 - absorbed / 2 is left of it on the average.
vec3 litEmission(vec4 mean, Illumination lit, Radiance radiance, Absorption piece)
{
  Light light = lit.direct;
#if TETMARCH_HEADLIGHT_SHADOWS
  real comes = radiance.transmittance * (real(1) - real(0.5) * piece.absorbed);
  light = addLight(light, dimLight(lit.head, comes));
#endif
  return reflection(mean, light);
}

#if TETMARCH_SAMPLED_SHADOWS
// Put by, as long as it isn't known how much light comes; before absorb().
void keepPending(INOUT(Radiance) radiance, vec4 mean, Illumination lit, Absorption piece)
{
  real weight = radiance.transmittance * piece.evenly * piece.thickness;
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

#if TETMARCH_ERROR_BOUND
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
