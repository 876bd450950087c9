// Shadows sampled at as many points of a ray as a tolerance takes, by control of the step size (Hairer, Norsett and
// Wanner, "Solving Ordinary Differential Equations I", 1987): if the light at both ends of a part differs too much for
// the colour that waits for it, the part is marched again, and ends earlier. Within a cell the step is halved instead.
// The error is an estimate: a shadow may fall between two samples, which are at most 3/64 of opacity apart.

CONSTANT real MOST_SPACING = real(0.03125);     // opacity between samples
CONSTANT real FIRST_SPACING = real(0.001953125);
CONSTANT real LEAST_STEP = real(0.015625);      // of the light that a cell absorbs
CONSTANT int MOST_PARTS = 256;                  // per ray
CONSTANT int MOST_REPEATS = 32;                 // of parts
CONSTANT int AT_BEGIN = 0;                      // which point of a step is sampled
CONSTANT int AT_END = 1;
CONSTANT int IN_MIDDLE = 2;

// The depth in the last visible cell before which it has absorbed a fraction of what it absorbs, if it does so evenly.
real depthAbsorbing(real fraction, March march)
{
  real absorbed = (march.pause.before - march.radiance.transmittance) / max(march.pause.before, TINY);
  real thin = fraction;
  real thick = log(max(real(1) - absorbed * fraction, TINY)) / min(log(max(real(1) - absorbed, TINY)), -TINY);
  return march.pause.seenBegin +
    (march.pause.seenEnd - march.pause.seenBegin) * (absorbed < real(0.0009765625) ? thin : thick);
}

struct PartLight
{
  vec4 mean;
  real error;   // estimated, of a channel
  bool tooLong; // only a shorter part keeps the tolerance
};

// The light of the part that waits, from where the transmittance was `begin`. divisible: it can end earlier.
PartLight samplePart(Ray ray, real begin, bool divisible, INOUT(March) march)
{
  PartLight part;
  part.mean = vec4(real(0), real(0), real(0), real(0));
  part.error = real(0);
  part.tooLong = false;
  vec4 low = march.pause.light;
  vec4 high = low;
  real position = real(0); // of the step in the part
  real step = real(1);     // its length
  int point = march.pause.lightKnown ? AT_END : AT_BEGIN;
  vec4 all = vec4(real(1), real(1), real(1), real(1));
  bool sampling = pendingTimes(all, march.radiance) > real(0.25) * lightTolerance ||
    (march.pause.due && !march.pause.lightFresh);
  real place = pendingPlace(begin, march.radiance);
  bool wasSampling = sampling;
  while (sampling && march.pause.samples < mostLightSamples)
  {
    march.pause.samples = march.pause.samples + 1;
    real at = point == AT_BEGIN ? real(0) : position + (point == AT_END ? step : real(0.5) * step);
    vec4 found = sampleLight(ray, march.pause.seenStart, depthAbsorbing(at, march));
    bool middle = point == IN_MIDDLE;
    vec4 between = middle ? (low + high) * real(0.5) : low;
    real error = real(0.5) * step * pendingTimes(found - between, march.radiance);
    bool within = error <= real(0.25) * lightTolerance || step <= LEAST_STEP || isFrugal(march.pause);
    bool accepted = within && point != AT_BEGIN;
    bool whole = point == AT_END && position <= real(0);
    part.tooLong = divisible && whole && !within;
    high = point == AT_END || (middle && !within) ? found : high;
    // Of the whole part it is known where it waits.
    vec4 mean = middle ? (between + found) * real(0.5) : low + (high - low) * (whole ? place : real(0.5));
    part.mean = part.mean + mean * (accepted ? step : real(0));
    part.error = part.error + (accepted ? error : real(0));
    low = accepted ? high : (point == AT_BEGIN ? found : low);
    position = position + (accepted ? step : real(0));
    real next = accepted ? min(real(2) * step, real(1) - position) : step;
    step = middle && !within ? real(0.5) * step : next;
    point = point == AT_BEGIN || accepted ? AT_END : IN_MIDDLE;
    sampling = position < real(1) && !part.tooLong;
  }
  part.mean = part.mean + low * (real(1) - position);
  march.pause.light = low;
  march.pause.lightKnown = march.pause.lightKnown || wasSampling;
  march.pause.lightFresh = wasSampling || march.pause.lightFresh;
  return part;
}

// jitter, 0..1, differs from pixel to pixel, so that the sampling error appears as noise, not as bands.
void marchAndSample(
  Ray ray, real thicknessPerDepth, real depthEnd, real jitter, INOUT(Traversal) traversal, INOUT(March) march)
{
  real spacing = FIRST_SPACING;
  int parts = 0;
  int repeats = 0;
  bool marching = true;
  while (marching && parts < MOST_PARTS)
  {
    March from = march;
    Traversal start = traversal;
    parts = parts + 1;
    march.pause.due = false;
    march.pause.nextSample =
      march.pause.samples < mostLightSamples && parts < MOST_PARTS ? march.radiance.transmittance - spacing : real(-1);
    marchOn(ray, thicknessPerDepth, depthEnd, traversal, march);
    // Mostly in cells before the last one, and not yet as short as the tolerance.
    real before = from.radiance.transmittance - march.pause.before;
    bool divisible = repeats < MOST_REPEATS && before > march.pause.before - march.radiance.transmittance &&
      spacing > real(0.25) * lightTolerance;
    marching = march.pause.due;
    PartLight part = samplePart(ray, from.radiance.transmittance, divisible, march);
    if (part.tooLong)
    {
      repeats = repeats + 1;
      spacing = spacing * real(0.25);
      int samples = march.pause.samples;
      march = from;
      march.pause.samples = samples;
      traversal = start;
      marching = true;
    }
    else
    {
      addPending(march.radiance, part.mean);
#if TETMARCH_LIGHT_ERROR
      march.radiance.lightError = march.radiance.lightError + part.error;
#endif
      bool even = part.error < real(0.125) * lightTolerance;
      real wide = MOST_SPACING * (parts > 1 ? real(1) : jitter + real(0.5));
      spacing = even ? wide : min(real(2) * spacing, wide);
    }
  }
}
