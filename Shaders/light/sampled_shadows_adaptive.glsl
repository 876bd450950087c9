// Light that is sampled at as many points of a ray as a tolerance takes, by control of the step size (Hairer, Norsett and
// Wanner, "Solving Ordinary Differential Equations I", 1987): if the light at both ends of a part differs too much for
// the colour that waits for it, the part is marched again, and ends earlier. All rays of a group march, then all sample:
// the turns of this loop are those of the ray with the most samples. The error is an estimate: a shadow may fall between
// two samples.

CONSTANT real FIRST_SPACING = real(0.001953125); // opacity before the first sample
CONSTANT real LEAST_SPACING = real(1e-6);        // a guard
CONSTANT real NO_SAMPLE = real(2);               // more than there is
CONSTANT int MOST_SAMPLES_OF_LIGHT = 4096;       // per ray; a guard

#if TETMARCH_COUNTS_TURNS
// Fewer than there are (march/loop_turns.glsl), since eight rays need different numbers: with half as many again, some
// rays through the scan of ./tetmarch bench light end early.
CONSTANT int MOST_TURNS = 26000;

// The greatest number of samples of a ray if none is dearer than the last one and the picture's march takes no more turns
// than it did. turns: before the last sample; afterwards they are those of the march alone.
int mostLightSamples(int turns)
{
  int turnsOfSample = max(loopTurns - turns, expectedLightTurns);
  loopTurns = turns;
  return (MOST_TURNS - turns) / turnsOfSample;
}
#endif

// Opacity between samples of even light: what no sample meets is less than that. left: samples for the rest of the ray.
real widestSpacing(int left, real transmittance)
{
  return max(real(2) * lightTolerance, real(1.5) * transmittance / real(max(left, 1)));
}

void setNextSample(real spacing, INOUT(March) march)
{
  march.pause.due = false;
  march.pause.nextSample = march.radiance.transmittance - spacing;
  march.pause.least = march.pause.nextSample - real(0.25) * spacing;
}

// jitter, 0..1, differs from pixel to pixel, so that the sampling error appears as noise, not as bands.
void marchAndSample(
  Ray ray, real thicknessPerDepth, real depthEnd, real jitter, INOUT(Traversal) traversal, INOUT(March) march)
{
  vec4 all = vec4(real(1), real(1), real(1), real(1));
  real budget = real(0.5) * lightTolerance; // of a part
  real spacing = FIRST_SPACING;
  vec4 light = all;
  bool known = false;
  int samples = 0;
  int most = MOST_SAMPLES_OF_LIGHT;
  bool marching = true;
  while (marching && samples <= MOST_SAMPLES_OF_LIGHT)
  {
    March from = march;
    Traversal start = traversal;
    samples = samples + 1;
    setNextSample(samples < most ? spacing : NO_SAMPLE, march);
    marchOn(ray, thicknessPerDepth, depthEnd, traversal, march);
    marching = march.pause.due;
    vec4 found = light;
    real waiting = pendingTimes(all, march.radiance);
    if (waiting > (marching ? real(0) : budget))
    {
#if TETMARCH_COUNTS_TURNS
      int turns = loopTurns;
#endif
      found = sampleLight(ray, march.pause.start, march.pause.depth);
#if TETMARCH_COUNTS_TURNS
      most = min(most, mostLightSamples(turns));
#endif
    }
    vec4 before = known ? light : found;
    real error = real(0.5) * (known ? pendingTimes(found - before, march.radiance) : waiting);
    real wide = widestSpacing(most - samples, march.radiance.transmittance);
    // Colours may be greater than the opacity: of bright light, or of several sources.
    bool coarse = error > budget || waiting > real(1.5) * wide;
    if (coarse && spacing > LEAST_SPACING && 2 * samples < most)
    {
      march = from;
      traversal = start;
      spacing = real(0.25) * spacing;
      marching = true;
    }
    else
    {
      real opacity = from.radiance.transmittance - march.radiance.transmittance;
      wide = wide / max(waiting / max(opacity, TINY), real(1));
      addPending(march.radiance, before + (found - before) * pendingPlace(from.radiance.transmittance, march.radiance));
#if TETMARCH_LIGHT_ERROR
      march.radiance.lightError = march.radiance.lightError + error;
#endif
      spacing = error < real(0.5) * budget ? wide * (known ? real(1) : jitter + real(0.5)) : min(real(2) * spacing, wide);
      light = found;
      known = true;
    }
  }
}
