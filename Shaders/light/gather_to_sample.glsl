// A sample of the light is due at a given transmittance of the ray, also within a cell.

CONSTANT real LEAST_PART_TO_SAMPLE = real(0.00048828125); // of an interval
CONSTANT int MOST_TRIALS_TO_SAMPLE = 64;                  // the last one takes the rest

// Whether a part that ends with that transmittance is to end earlier. length: of the part, in 0..1 of the interval.
bool isBeyondSample(real transmittance, real length, SamplePause pause)
{
  return transmittance < pause.least && length > LEAST_PART_TO_SAMPLE;
}

// The fraction of a part with the given transmittances at its ends at which the sample is due, if it absorbs evenly.
real fractionToSample(real before, real behind, SamplePause pause)
{
  real target = real(0.5) * (pause.nextSample + pause.least);
  real depth = log(max(before, TINY) / max(behind, TINY));
  return clamp(log(max(before, TINY) / max(target, TINY)) / max(depth, TINY), LEAST_PART_TO_SAMPLE, real(0.9375));
}

#if !TETMARCH_LIT_PARTS
// As gatherCell(), up to the next sample: then the interval ends there.
int gatherToSample(
  real thicknessPerDepth, INOUT(CellInterval) cell, INOUT(Radiance) radiance, INOUT(SamplePause) pause)
{
  vec2 whole = vec2(cell.begin, cell.end);
  real position = real(0); // of the part in the interval
  real step = real(1);     // its length
  int lookups = 0;
  int trials = 0;
  bool pending = true;
  while (pending && trials < MOST_TRIALS_TO_SAMPLE)
  {
    trials = trials + 1;
    bool rest = trials == MOST_TRIALS_TO_SAMPLE;
    real end = rest || step >= real(1) - position ? real(1) : position + step;
    cell.begin = position > real(0) ? whole.x + (whole.y - whole.x) * position : whole.x;
    cell.end = end < real(1) ? whole.x + (whole.y - whole.x) * end : whole.y;
    Radiance tried = radiance;
    lookups = lookups + gatherCell(thicknessPerDepth, cell, tried);
    if (isBeyondSample(tried.transmittance, end - position, pause) && !rest)
    {
      step = (end - position) * fractionToSample(radiance.transmittance, tried.transmittance, pause);
    }
    else
    {
      radiance = tried;
      step = real(2) * (end - position);
      position = end;
      pending = position < real(1) && !isOpaque(radiance) && radiance.transmittance > pause.nextSample;
    }
  }
#if TETMARCH_COUNTS_TURNS
  countTurns(trials + 1);
#endif
  pause.within = position < real(1) && radiance.transmittance <= pause.nextSample && !isOpaque(radiance);
  cell.begin = whole.x;
  cell.end = pause.within ? cell.end : whole.y;
  return lookups;
}
#endif
