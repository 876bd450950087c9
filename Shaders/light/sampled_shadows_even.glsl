// Shadows sampled at a few points of a ray, at equal steps of opacity. The part between two samples is stored until the
// second one is known, and uses the mean of both.

CONSTANT real SAMPLE_SPACING = real(0.0625);    // opacity between samples
CONSTANT real FIRST_SAMPLE = real(0.001953125); // opacity before the first sample
CONSTANT int MOST_LIGHT_SAMPLES = 20;           // per ray: 1 / SAMPLE_SPACING, the first two, and some for rounding

// jitter, 0..1, differs from pixel to pixel, so that the sampling error appears as noise, not as bands.
void marchAndSample(
  Ray ray, real thicknessPerDepth, real depthEnd, real jitter, INOUT(Traversal) traversal, INOUT(March) march)
{
  vec4 light = vec4(real(1), real(1), real(1), real(1));
  bool sampled = false;
  int samples = 0;
  bool marching = true;
  march.pause.nextSample = real(1) - FIRST_SAMPLE;
  real spacing = SAMPLE_SPACING * (jitter + real(0.5));
  while (marching && samples <= MOST_LIGHT_SAMPLES)
  {
    march.pause.due = false;
    samples = samples + 1;
    marchOn(ray, thicknessPerDepth, depthEnd, traversal, march);
    if (march.pause.due)
    {
      // The part before the first sample may be one thick cell.
      vec4 next = sampleLight(ray, march.pause.start, sampled ? march.done : march.pause.seenDepth);
      addPending(march.radiance, sampled ? (light + next) * real(0.5) : next);
      light = next;
      sampled = true;
      march.pause.nextSample = march.radiance.transmittance - spacing;
      spacing = SAMPLE_SPACING;
    }
    marching = march.pause.due;
  }
  addPending(march.radiance, light);
}
