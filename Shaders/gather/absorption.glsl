// The contribution of a subsegment to the radiance of a ray (Max, "Optical models", 1995).

// The absorption of light in a subsegment.
struct Absorption
{
  real thickness; // in scalar opacity unit distances
  real depth;     // optical depth
  real evenly;    // (1 - exp(-depth)) / depth
  real absorbed;  // 1 - exp(-depth)
};

// mean: of C tau and tau. The series below 1/8, accurate to 4e-8, avoids cancellation.
Absorption absorption(vec4 mean, real thickness)
{
  Absorption found;
  found.thickness = thickness;
  real depth = mean.w * thickness;
  real series = real(1) -
    depth * (real(0.5) - depth * (real(1) / real(6) - depth * (real(1) / real(24) - depth * (real(1) / real(120)))));
  found.depth = depth;
  found.evenly = depth < real(0.125) ? series : (real(1) - exp(-depth)) / depth;
  found.absorbed = depth * found.evenly;
  return found;
}

#if TETMARCH_SAMPLED_SHADOWS || TETMARCH_LIGHT_TOLERANCE
// The mean position, 0..1, of the visible light of a homogeneous interval, given the transmittance before and behind
// it: with its optical depth D it is 1 / D - 1 / (exp(D) - 1), a half in a thin one.
real seenFraction(real before, real behind)
{
  real absorbed = (before - behind) / max(before, TINY);
  real depth = -log(max(real(1) - absorbed, TINY));
  real thin = real(0.5) - depth * (real(1) / real(12));
  return depth < real(0.05) ? thin : real(1) / depth - (real(1) - absorbed) / max(absorbed, TINY);
}
#endif

void absorb(INOUT(Radiance) radiance, vec3 emitted, Absorption by)
{
  radiance.color = radiance.color + emitted * (radiance.transmittance * by.evenly * by.thickness);
  radiance.transmittance = radiance.transmittance * max(real(1) - by.absorbed, real(0));
}

#if TETMARCH_NAN_SHOWN
// An interval in which the scalar is not finite: it has one colour and extinction, but no gradient and therefore no
// light.
void absorbNan(INOUT(Radiance) radiance, real thickness)
{
#if TETMARCH_SHOW_ILLUMINATION
  vec3 color = vec3(real(1), real(1), real(1));
#elif TETMARCH_SHOW_GRADIENTS
  vec3 color = vec3(real(0.5), real(0.5), real(0.5)); // as where the gradient is 0
#else
  vec3 color = vec3(nanColor.x, nanColor.y, nanColor.z);
#endif
  absorb(radiance, color * nanColor.w, absorption(nanColor, thickness));
}
#endif
