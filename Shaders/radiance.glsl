// What a ray has gathered, and how a piece of the volume adds to it (Max, "Optical models", 1995).

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

// What a piece does to the light that comes into it.
struct Absorption
{
  real opticalLength; // in scalar opacity unit distances
  real depth;         // optical depth
  real evenly;        // (1 - exp(-depth)) / depth
  real absorbed;      // 1 - exp(-depth)
};

// mean: of C tau and tau. The series below 1/8, good to 4e-8, has no cancellation.
Absorption absorption(vec4 mean, real opticalLength)
{
  Absorption piece;
  piece.opticalLength = opticalLength;
  real depth = mean.w * opticalLength;
  real series = real(1) -
    depth * (real(0.5) - depth * (real(1) / real(6) - depth * (real(1) / real(24) - depth / real(120))));
  piece.depth = depth;
  piece.evenly = depth < real(0.125) ? series : (real(1) - exp(-depth)) / depth;
  piece.absorbed = depth * piece.evenly;
  return piece;
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

void absorb(INOUT(Radiance) radiance, vec3 emitted, Absorption piece)
{
  radiance.color = radiance.color + emitted * (radiance.transmittance * piece.evenly * piece.opticalLength);
  radiance.transmittance = radiance.transmittance * max(real(1) - piece.absorbed, real(0));
}

#if TETMARCH_NAN_SHOWN
// A piece in which the scalar is not finite: of one colour and extinction, without gradient and so without light.
void absorbNan(INOUT(Radiance) radiance, real opticalLength)
{
#if TETMARCH_SHOW_ILLUMINATION
  vec3 color = vec3(real(1), real(1), real(1));
#elif TETMARCH_SHOW_GRADIENTS
  vec3 color = vec3(real(0.5), real(0.5), real(0.5)); // as where there is none
#else
  vec3 color = vec3(nanColor.x, nanColor.y, nanColor.z);
#endif
  Absorption piece = absorption(nanColor, opticalLength);
  absorb(radiance, color * nanColor.w, piece);
}
#endif
