// One ray of the picture, with samples of the light on it.
March castSampledRay(
  Ray ray, real thicknessPerDepth, real depthBegin, real depthEnd, real jitter)
{
  March march = beginMarch(depthBegin);
  Traversal traversal = traversalFrom(ray, depthBegin);
  marchAndSample(ray, thicknessPerDepth, depthEnd, jitter, traversal, march);
  return march;
}
