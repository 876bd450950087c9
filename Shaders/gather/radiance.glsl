// The state of a ray, accumulated front to back: its colour, and the transmittance for everything behind.

struct Radiance
{
  vec3 color; // premultiplied
  real transmittance;
#if TETMARCH_ERROR_BOUND
  real error;      // error bound of each channel of color, without rounding, steps of the integrals and light
#endif
#if TETMARCH_TABLE_ERROR
  real lookedUp;   // thickness over the number of bins of the mean, attenuated by the transmittance
#endif
#if TETMARCH_LIGHT_ERROR
  real lightError; // the same for the light
#endif
#if TETMARCH_CURVED_ERROR
  real curvedError; // the same for the shape of curved cells, up to the last face
  ShiftedFace face; // that one
#endif
#if TETMARCH_LIT_PARTS
  real shadeError; // estimated, by the change of light within parts of cells
#endif
#if TETMARCH_PAUSES_WITHIN
  real pendingWeight; // of the colours that wait for light,
  real pendingMoment; // times the transmittance where they are
#endif
#if TETMARCH_SAMPLED_BEAMS
  vec3 pendingA; // colour by each light whose transmittance is known at the next sample
#if TETMARCH_SEVERAL_SHADOWS
  vec3 pendingB;
  vec3 pendingC;
#endif
#endif
#if TETMARCH_SAMPLED_OCCLUSION
  vec3 pendingAmbient; // the same by ambient light
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
#if TETMARCH_CURVED_ERROR
  radiance.curvedError = real(0);
  radiance.face = noFace();
#endif
#if TETMARCH_LIT_PARTS
  radiance.shadeError = real(0);
#endif
#if TETMARCH_PAUSES_WITHIN
  radiance.pendingWeight = real(0);
  radiance.pendingMoment = real(0);
#endif
#if TETMARCH_SAMPLED_BEAMS
  radiance.pendingA = radiance.color;
#if TETMARCH_SEVERAL_SHADOWS
  radiance.pendingB = radiance.color;
  radiance.pendingC = radiance.color;
#endif
#endif
#if TETMARCH_SAMPLED_OCCLUSION
  radiance.pendingAmbient = radiance.color;
#endif
  return radiance;
}

#if TETMARCH_ADAPTIVE
// A quarter of a pixel's tolerance is available from the begin, half of it in proportion to the ray's absorption; the
// rest is for the part behind the end of the ray. A subsegment uses at most a quarter of the available budget:
// otherwise those behind it would have to be shorter than justified by its gain.
#if TETMARCH_VISITS
uniform float toleranceAtOnce; // that quarter, divided between the processes that have parts of the ray
#define TOLERANCE_AT_ONCE toleranceAtOnce
#else
CONSTANT real TOLERANCE_AT_ONCE = real(0.25);
#endif
CONSTANT real TOLERANCE_BY_ABSORPTION = real(0.5);
CONSTANT real SHARE_OF_A_SUBSEGMENT = real(0.25);

// The error budget of the next subsegment, given its absorption of the pixel's light.
real errorBudget(Radiance radiance, real absorbed)
{
#if TETMARCH_PICKED
  real tolerance = PICK_TOLERANCE; // errorTolerance is the transmittance at the picked point
#else
  real tolerance = errorTolerance;
#endif
  real earned = TOLERANCE_AT_ONCE + TOLERANCE_BY_ABSORPTION * (real(1) - radiance.transmittance + absorbed);
  // The used part may exceed the budget by rounding.
  return largerOf(SHARE_OF_A_SUBSEGMENT * (tolerance * earned - radiance.error),
    tolerance * TOLERANCE_BY_ABSORPTION * absorbed);
}
#endif

// Whether the part behind can't change a channel by more than the remaining tolerance.
bool isOpaque(Radiance radiance)
{
#if TETMARCH_ADAPTIVE && !TETMARCH_PICKED
  return radiance.transmittance + radiance.error < errorTolerance;
#else
  return radiance.transmittance < errorTolerance;
#endif
}

// Error bound of each channel of the pixel if the ray ends here.
real errorBound(Radiance radiance)
{
#if TETMARCH_POINT_SAMPLED
  return real(1); // nothing is known between samples
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
#if TETMARCH_CURVED_ERROR
  bound = bound + radiance.curvedError + shiftedFaceError(radiance.face, NO_MEDIUM, radiance.transmittance);
#endif
  return bound;
#endif
}

#if TETMARCH_PICKED
// A quantity that grows along the ray: the opacity minus 1. The opacity itself would be rounded.
real gathered(Radiance radiance) { return -radiance.transmittance; }
#endif

// Premultiplied colour and opacity of the pixel.
vec4 pixelOf(Radiance radiance, real thicknessPerDepth)
{
  return vec4(radiance.color.x, radiance.color.y, radiance.color.z, real(1) - radiance.transmittance);
}

// The emission of a subsegment by its own colour. Colours are at most 1; by rounding their mean, and so pixels, could
// exceed 1.
vec3 emission(vec4 mean)
{
#if TETMARCH_SHOW_ILLUMINATION
  return vec3(mean.w, mean.w, mean.w);
#elif TETMARCH_CONSTANT_COLOR
  return constantColor * mean.w;
#elif TETMARCH_LIT_COMPONENTS
  return vec3(mean.x, mean.y, mean.z); // in light
#else
  return vec3(smallerOf(mean.x, mean.w), smallerOf(mean.y, mean.w), smallerOf(mean.z, mean.w));
#endif
}
