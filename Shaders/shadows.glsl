// Light that the volume, or opaque geometry, keeps from a point.

#if TETMARCH_OPAQUE_SHADOWS || TETMARCH_CAST_SHADOWS && !TETMARCH_SAMPLED_SHADOWS
real incomingFrom(int channel, vec4 incoming)
{
  return channel == 0 ? incoming.y : (channel == 1 ? incoming.z : incoming.w);
}
#endif

// Part of a light may shine through whatever lies between it and the point; the rest is seen as far as it comes.
void addShadowed(INOUT(Illumination) lit, int i, Light light, vec4 incoming)
{
  Light beam = dimLight(light, fetchShadowStrength(i));
  light = dimLight(light, real(1) - fetchShadowStrength(i));
  int channel = fetchShadowChannel(i); // -1: of a headlight
#if TETMARCH_HEADLIGHT_SHADOWS
  lit.head = addLight(lit.head, dimLight(beam, channel < 0 ? real(1) : real(0)));
#endif
#if TETMARCH_SAMPLED_SHADOWS
#if TETMARCH_OPAQUE_SHADOWS
  beam = dimLight(beam, incomingFrom(channel, incoming)); // past opaque geometry; the volume is yet to be looked at
#endif
  for (int k = 0; k < 3; ++k)
  {
    lit.beam[k] = addLight(lit.beam[k], dimLight(beam, channel == k ? real(1) : real(0)));
  }
#elif TETMARCH_CAST_SHADOWS
  light = addLight(light, dimLight(beam, channel < 0 ? real(0) : incomingFrom(channel, incoming)));
#endif
  lit.direct = addLight(lit.direct, light);
}
