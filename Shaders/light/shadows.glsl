// Shadows of the volume and of opaque geometry at a point.

#if TETMARCH_SHADOWS_AT_VERTICES
// The transmittance of a channel, 0 to 2.
real incomingFrom(int channel, vec4 incoming)
{
#if TETMARCH_SEVERAL_SHADOWS
  return channel == 0 ? incoming.y : (channel == 1 ? incoming.z : incoming.w);
#else
  return incoming.y;
#endif
}
#endif

// Adds a light. The share 1 - strength of it is not attenuated; the rest is multiplied by the transmittance.
void addShadowed(INOUT(Illumination) lit, int i, Light light, vec4 incoming)
{
  int channel = fetchShadowChannel(i); // -1: of a headlight
  real strength = fetchShadowStrength(i);
  real kept = real(0); // removed from the direct light: absorbed, or added separately
#if TETMARCH_HEADLIGHT_SHADOWS
  real head = channel < 0 ? strength : real(0);
  lit.head = addLight(lit.head, dimLight(light, head));
  kept = head;
#endif
#if TETMARCH_SAMPLED_BEAMS
  kept = channel < 0 ? kept : strength;
  lit.beamA = addLight(lit.beamA, dimLight(light, channel == 0 ? strength : real(0)));
#if TETMARCH_SEVERAL_SHADOWS
  lit.beamB = addLight(lit.beamB, dimLight(light, channel == 1 ? strength : real(0)));
  lit.beamC = addLight(lit.beamC, dimLight(light, channel == 2 ? strength : real(0)));
#endif
#elif TETMARCH_CAST_SHADOWS
  kept = channel < 0 ? kept : strength * (real(1) - incomingFrom(channel, incoming));
#endif
  lit.direct = addLight(lit.direct, dimLight(light, real(1) - kept));
}
