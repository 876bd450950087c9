// What a ray has gathered front to back: colour, and how much is seen of what lies behind.

struct Radiance
{
  vec3 color; // premultiplied
  real transmittance;
#if TETMARCH_ERROR_BOUND
  real error; // no channel of color is off by more, but for rounding and what the tables lack
#endif
#if TETMARCH_LIGHT_ERROR
  real lightError; // and for this, of light that changes along a piece
#endif
#if TETMARCH_SAMPLED_SHADOWS
  vec3 pendingA; // color by each light of which is not known yet how much comes through the volume
#if TETMARCH_SEVERAL_SHADOWS
  vec3 pendingB;
  vec3 pendingC;
#endif
#endif
};

Radiance noRadiance()
{
  Radiance radiance;
  radiance.color = vec3(real(0), real(0), real(0));
  radiance.transmittance = real(1);
#if TETMARCH_ERROR_BOUND
  radiance.error = real(0);
#endif
#if TETMARCH_LIGHT_ERROR
  radiance.lightError = real(0);
#endif
#if TETMARCH_SAMPLED_SHADOWS
  radiance.pendingA = radiance.color;
#if TETMARCH_SEVERAL_SHADOWS
  radiance.pendingB = radiance.color;
  radiance.pendingC = radiance.color;
#endif
#endif
  return radiance;
}

#if TETMARCH_ADAPTIVE
// A quarter of a pixel's tolerance may be used up at once, half as the ray is absorbed; the rest is for what lies
// behind its end.
CONSTANT real TOLERANCE_AT_ONCE = real(0.25);
CONSTANT real TOLERANCE_BY_ABSORPTION = real(0.5);

// How far the next piece may be off that absorbs so much of the light of the pixel.
real errorBudget(Radiance radiance, real absorbed)
{
  real earned = TOLERANCE_AT_ONCE + TOLERANCE_BY_ABSORPTION * (real(1) - radiance.transmittance + absorbed);
  // Rounding may have spent a little more than was there.
  return max(errorTolerance * earned - radiance.error, errorTolerance * TOLERANCE_BY_ABSORPTION * absorbed);
}
#endif

// Whether what lies behind can't change a channel by more than the tolerance leaves.
bool isOpaque(Radiance radiance)
{
#if TETMARCH_ADAPTIVE
  return radiance.transmittance + radiance.error < errorTolerance;
#else
  return radiance.transmittance < errorTolerance;
#endif
}

// What any channel of the pixel may be off by, when the ray ends here.
real errorBound(Radiance radiance)
{
  real bound = isOpaque(radiance) ? radiance.transmittance : real(0);
#if TETMARCH_ERROR_BOUND
  bound = bound + radiance.error;
#endif
#if TETMARCH_LIGHT_ERROR
  bound = bound + radiance.lightError;
#endif
  return bound;
}

#if TETMARCH_PICKED
// What grows along the ray: the opacity, less 1, which would round it.
real gathered(Radiance radiance) { return -radiance.transmittance; }
#endif

// Premultiplied colour and opacity of the pixel.
vec4 pixelOf(Radiance radiance, real thicknessPerDepth)
{
  return vec4(radiance.color.x, radiance.color.y, radiance.color.z, real(1) - radiance.transmittance);
}

// What a piece sends out, by its own colour. Colours are at most 1; rounding could make their mean a little more, and
// pixels with it.
vec3 emission(vec4 mean)
{
#if TETMARCH_SHOW_ILLUMINATION
  return vec3(mean.w, mean.w, mean.w);
#elif TETMARCH_CONSTANT_COLOR
  return constantColor * mean.w;
#else
  return vec3(min(mean.x, mean.w), min(mean.y, mean.w), min(mean.z, mean.w));
#endif
}
