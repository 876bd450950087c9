// A lit subsegment.

// Its emission. Light from the eye is absorbed on the way to a point as much as its reflection on the way back: by the
// ray's transmittance. Averaged over the visible part of the subsegment, 1 - absorbed / 2 of that light remains.
vec3 litEmission(vec4 mean, Illumination lit, Radiance radiance, Absorption by)
{
  Light light = lit.direct;
#if TETMARCH_HEADLIGHT_SHADOWS
  real transmittance = radiance.transmittance * (real(1) - real(0.5) * by.absorbed);
  light = addLight(light, dimLight(lit.head, transmittance));
#endif
  return reflection(mean, light);
}

#if TETMARCH_ERROR_BOUND || TETMARCH_CURVED_ERROR || TETMARCH_LIGHT_ERROR || TETMARCH_LIGHT_TOLERANCE
real greatest(vec3 v) { return max(abs(v.x), max(abs(v.y), abs(v.z))); }
#endif

#if TETMARCH_SAMPLED_SHADOWS
// Stores the subsegment's reflection of the lights whose transmittance is known at the next sample; before absorb().
void keepPending(INOUT(Radiance) radiance, vec4 mean, Illumination lit, Absorption by)
{
  real weight = radiance.transmittance * by.evenly * by.thickness;
#if TETMARCH_LIGHT_TOLERANCE
  real waiting = weight * greatest(vec3(mean.x, mean.y, mean.z));
  radiance.pendingWeight = radiance.pendingWeight + waiting;
  radiance.pendingMoment =
    radiance.pendingMoment + waiting * radiance.transmittance * (real(1) - real(0.5) * by.absorbed);
#endif
#if TETMARCH_SAMPLED_BEAMS
  radiance.pendingA = radiance.pendingA + reflection(mean, lit.beamA) * weight;
#endif
#if TETMARCH_SEVERAL_SHADOWS
  radiance.pendingB = radiance.pendingB + reflection(mean, lit.beamB) * weight;
  radiance.pendingC = radiance.pendingC + reflection(mean, lit.beamC) * weight;
#endif
#if TETMARCH_SAMPLED_OCCLUSION
  radiance.pendingAmbient = radiance.pendingAmbient + emission(mean) * ambientColor * weight;
#endif
}
#endif

#if TETMARCH_ERROR_BOUND || TETMARCH_TABLE_ERROR || TETMARCH_CURVED_ERROR
// The maximum brightness of a colour of 1.
real brightness(Illumination lit)
{
  real bright = greatest(lit.direct.diffuse);
#if TETMARCH_HEADLIGHT_SHADOWS
  bright = bright + greatest(lit.head.diffuse);
#endif
#if TETMARCH_SAMPLED_BEAMS
  bright = bright + greatest(lit.beamA.diffuse);
#if TETMARCH_SEVERAL_SHADOWS
  bright = bright + greatest(lit.beamB.diffuse) + greatest(lit.beamC.diffuse);
#endif
#endif
#if TETMARCH_SAMPLED_OCCLUSION
  bright = bright + greatest(ambientColor);
#endif
  return bright;
}
#endif
