// Shadows sampled at a few points of a ray, at equal steps of opacity. The part between two samples is stored until the
// second one is known, and uses the mean of both.

CONSTANT real SAMPLE_SPACING = real(0.0625);    // opacity between samples
CONSTANT real FIRST_SAMPLE = real(0.001953125); // opacity before the first sample
CONSTANT int MOST_LIGHT_SAMPLES = 20;           // per ray: 1 / SAMPLE_SPACING, the first two, and some for rounding

// The transmittance towards each light from a point in the cell after which the march has paused.
vec3 sampleLight(Ray ray, March march, real depth)
{
  LightStart start = march.pause.start;
  start.point = ray.origin + ray.direction * depth;
  vec3 light = vec3(real(1), real(1), real(1));
  for (int k = 0; k < shadowSourceCount; ++k)
  {
    vec4 source = fetchShadowSource(k);
    vec3 toLight = vec3(source.x, source.y, source.z) - start.point * source.w;
    real far = sqrt(dot(toLight, toLight));
    real transmittance = transmittanceTo(
      start, toLight * (real(1) / max(far, TINY)), min(source.w > real(0) ? far : NO_DEPTH, lightReach));
    light.x = k == 0 ? transmittance : light.x;
    light.y = k == 1 ? transmittance : light.y;
    light.z = k == 2 ? transmittance : light.z;
  }
  return light;
}

// Adds the stored part, with the given transmittance of the light.
void addPending(INOUT(Radiance) radiance, vec3 transmittance)
{
  radiance.color = radiance.color + radiance.pendingA * transmittance.x;
  radiance.pendingA = vec3(real(0), real(0), real(0));
#if TETMARCH_SEVERAL_SHADOWS
  radiance.color = radiance.color + radiance.pendingB * transmittance.y + radiance.pendingC * transmittance.z;
  radiance.pendingB = radiance.pendingA;
  radiance.pendingC = radiance.pendingA;
#endif
}

// jitter, 0..1, differs from pixel to pixel, so that the sampling error appears as noise, not as bands.
void marchAndSample(
  Ray ray, real thicknessPerDepth, real depthEnd, real jitter, INOUT(Traversal) traversal, INOUT(March) march)
{
  vec3 light = vec3(real(1), real(1), real(1));
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
      vec3 next = sampleLight(ray, march, sampled ? march.done : march.pause.seenDepth);
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

March castSampledRay(
  Ray ray, real thicknessPerDepth, real depthBegin, real depthEnd, real jitter)
{
  March march = beginMarch(depthBegin);
  Traversal traversal = traversalFrom(ray, depthBegin);
  marchAndSample(ray, thicknessPerDepth, depthEnd, jitter, traversal, march);
  return march;
}
