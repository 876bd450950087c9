// Shadows looked for along a ray, at a few points, evenly in terms of what is seen of the volume. What lies between two
// of them is put by until the second is known, and has the mean of both.

CONSTANT real SAMPLED_SHARE = real(0.0625);    // of the opacity, from sample to sample
CONSTANT real FIRST_SAMPLE = real(0.001953125); // so much has to be seen of the volume

// What comes from each light to a point in the tetrahedron behind which the march has paused.
vec3 sampleLight(Ray ray, March march, real depth)
{
  vec3 point = ray.origin + ray.direction * depth;
  vec3 light = vec3(real(1), real(1), real(1));
  for (int k = 0; k < shadowSourceCount; ++k)
  {
    vec4 source = fetchShadowSource(k);
    vec3 towards = vec3(source.x, source.y, source.z) - point * source.w;
    real far = sqrt(dot(towards, towards));
    real comes = transmittanceTowards(march.last, point, towards * (real(1) / max(far, TINY)),
      min(source.w > real(0) ? far : NO_DEPTH, lightReach));
    light.x = k == 0 ? comes : light.x;
    light.y = k == 1 ? comes : light.y;
    light.z = k == 2 ? comes : light.z;
  }
  return light;
}

// What was put by is seen in light that comes.
void addPending(INOUT(Radiance) radiance, vec3 comes)
{
  radiance.color = radiance.color + radiance.pendingA * comes.x;
  radiance.pendingA = vec3(real(0), real(0), real(0));
#if TETMARCH_SEVERAL_SHADOWS
  radiance.color = radiance.color + radiance.pendingB * comes.y + radiance.pendingC * comes.z;
  radiance.pendingB = radiance.pendingA;
  radiance.pendingC = radiance.pendingA;
#endif
}

// jitter, 0..1, differs from pixel to pixel, so that what lies between samples shows as noise instead of as bands.
void marchAndSample(
  Ray ray, real thicknessPerDepth, real depthEnd, real jitter, INOUT(Traversal) traversal, INOUT(March) march)
{
  vec3 comes = vec3(real(1), real(1), real(1));
  bool sampled = false;
  march.nextSample = real(1) - FIRST_SAMPLE;
  real share = SAMPLED_SHARE * (jitter + real(0.5));
  do
  {
    march.paused = false;
    marchOn(ray, thicknessPerDepth, depthEnd, traversal, march);
    if (march.paused)
    {
      // What was seen before the first sample may be one thick cell.
      vec3 next = sampleLight(ray, march, sampled ? march.done : march.seenDepth);
      addPending(march.radiance, sampled ? (comes + next) * real(0.5) : next);
      comes = next;
      sampled = true;
      march.nextSample = march.radiance.transmittance - share;
      share = SAMPLED_SHARE;
    }
  } while (march.paused);
  addPending(march.radiance, comes);
}

March castSampledRay(
  Ray ray, int firstFace, real thicknessPerDepth, real depthBegin, real depthEnd, real jitter)
{
  March march = beginMarch(depthBegin);
  Traversal traversal = traversalFromBoundary(ray, firstFace);
  marchAndSample(ray, thicknessPerDepth, depthEnd, jitter, traversal, march);
  return march;
}
