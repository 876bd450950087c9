// Light that the volume keeps from a point.

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
  lit.beamA = addLight(lit.beamA, dimLight(beam, channel == 0 ? real(1) : real(0)));
  lit.beamB = addLight(lit.beamB, dimLight(beam, channel == 1 ? real(1) : real(0)));
  lit.beamC = addLight(lit.beamC, dimLight(beam, channel == 2 ? real(1) : real(0)));
#elif TETMARCH_CAST_SHADOWS
  real comes = channel == 0 ? incoming.y : (channel == 1 ? incoming.z : incoming.w);
  light = addLight(light, dimLight(beam, channel < 0 ? real(0) : comes));
#endif
  lit.direct = addLight(lit.direct, light);
}
