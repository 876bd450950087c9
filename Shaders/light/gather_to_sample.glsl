// A sample of the light is due at a given transmittance of the ray, also within a cell.

CONSTANT real LEAST_PART_TO_SAMPLE = real(0.00048828125); // of an interval
CONSTANT int MOST_CUTS = 8;                               // of an interval

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
  real extent = cell.end - cell.begin;
  real length = real(1);
  int lookups = 0;
  int cuts = 0;
  bool beyond = true;
  Radiance before = radiance;
  while (beyond && cuts < MOST_CUTS)
  {
    radiance = before;
    lookups = lookups + gatherCell(thicknessPerDepth, cell, radiance);
    cuts = cuts + 1;
    beyond = isBeyondSample(radiance.transmittance, length, pause) && cuts < MOST_CUTS;
    if (beyond)
    {
      length = length * fractionToSample(before.transmittance, radiance.transmittance, pause);
      cell.end = cell.begin + extent * length;
    }
  }
  pause.within = length < real(1) && !isOpaque(radiance);
  return lookups;
}
#endif
