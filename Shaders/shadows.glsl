// Light that the volume keeps from a point.

// Part of a light may shine through whatever lies between it and the point; the rest is seen as far as it comes.
void addShadowed(INOUT(Illumination) lit, int i, Light light, vec4 incoming)
{
  int channel = fetchShadowChannel(i); // -1: of a headlight
  real strength = fetchShadowStrength(i);
  real kept = real(0); // or yet to be looked for
#if TETMARCH_HEADLIGHT_SHADOWS
  real head = channel < 0 ? strength : real(0);
  lit.head = addLight(lit.head, dimLight(light, head));
  kept = head;
#endif
#if TETMARCH_SAMPLED_SHADOWS
  for (int k = 0; k < SHADOW_CHANNELS; ++k)
  {
    real beam = channel == k ? strength : real(0);
    lit.beam[k] = addLight(lit.beam[k], dimLight(light, beam));
    kept = kept + beam;
  }
#elif TETMARCH_CAST_SHADOWS
#if TETMARCH_SEVERAL_SHADOWS
  real comes = channel == 0 ? incoming.y : (channel == 1 ? incoming.z : incoming.w);
#else
  real comes = incoming.y;
#endif
  kept = channel < 0 ? kept : strength * (real(1) - comes);
#endif
  lit.direct = addLight(lit.direct, dimLight(light, real(1) - kept));
}
