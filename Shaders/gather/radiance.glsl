// What a ray has gathered front to back: its colour, and the transmittance, by which all behind is seen.

struct Radiance
{
  vec3 color; // premultiplied
  real transmittance;
#if TETMARCH_ERROR_BOUND
  real error;      // no channel of color is off by more, but for rounding, the steps of the integrals and the light
#endif
#if TETMARCH_TABLE_ERROR
  real lookedUp;   // thickness over the number of bins of the mean that was looked up, seen through the transmittance
#endif
#if TETMARCH_LIGHT_ERROR
  real lightError; // this error of the light
#endif
#if TETMARCH_SAMPLED_SHADOWS
  vec3 pendingA; // colour by each light whose transmittance the next sample will tell
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
#if TETMARCH_TABLE_ERROR
  radiance.lookedUp = real(0);
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
// A quarter of a pixel's tolerance may be used up from the begin, half of it in proportion to what the ray absorbs; the
// rest is for what lies behind the end of the ray. No subsegment uses more than a quarter of what there is: those behind
// it, with little left, would have to be shorter than it has gained.
#if TETMARCH_VISITS
uniform float toleranceAtOnce; // that quarter, shared by all processes, of which each has a part of the ray
#define TOLERANCE_AT_ONCE toleranceAtOnce
#else
CONSTANT real TOLERANCE_AT_ONCE = real(0.25);
#endif
CONSTANT real TOLERANCE_BY_ABSORPTION = real(0.5);
CONSTANT real SHARE_OF_A_SUBSEGMENT = real(0.25);

// How far the next subsegment may be off, which absorbs that much of the pixel's light.
real errorBudget(Radiance radiance, real absorbed)
{
#if TETMARCH_PICKED
  real tolerance = PICK_TOLERANCE; // the other one is what is left of the light at the point that is picked
#else
  real tolerance = errorTolerance;
#endif
  real earned = TOLERANCE_AT_ONCE + TOLERANCE_BY_ABSORPTION * (real(1) - radiance.transmittance + absorbed);
  // Rounding may have used a little more than there was.
  return max(SHARE_OF_A_SUBSEGMENT * (tolerance * earned - radiance.error),
    tolerance * TOLERANCE_BY_ABSORPTION * absorbed);
}
#endif

// Whether what lies behind cannot change a channel by more than is left of the tolerance.
bool isOpaque(Radiance radiance)
{
#if TETMARCH_ADAPTIVE && !TETMARCH_PICKED
  return radiance.transmittance + radiance.error < errorTolerance;
#else
  return radiance.transmittance < errorTolerance;
#endif
}

// No channel of the pixel is off by more, if the ray ends here.
real errorBound(Radiance radiance)
{
#if TETMARCH_POINT_SAMPLED
  return real(1); // what lies between samples may be anything
#else
  real bound = isOpaque(radiance) ? radiance.transmittance : real(0);
#if TETMARCH_ERROR_BOUND
  bound = bound + radiance.error;
#endif
#if TETMARCH_TABLE_ERROR
  bound = bound + min(radiance.lookedUp * errorOfSteps(), real(1));
#endif
#if TETMARCH_LIGHT_ERROR
  bound = bound + radiance.lightError;
#endif
  return bound;
#endif
}

#if TETMARCH_PICKED
// What grows along the ray: the opacity less 1. The opacity itself would be rounded.
real gathered(Radiance radiance) { return -radiance.transmittance; }
#endif

// Premultiplied colour and opacity of the pixel.
vec4 pixelOf(Radiance radiance, real thicknessPerDepth)
{
  return vec4(radiance.color.x, radiance.color.y, radiance.color.z, real(1) - radiance.transmittance);
}

// What a subsegment emits by its own colour. Colours are at most 1; rounding could make their mean, and so pixels, a
// little more.
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
