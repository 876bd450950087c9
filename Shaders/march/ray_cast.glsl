// One ray of the picture.
March castPlainRay(Ray ray, real thicknessPerDepth, real depthBegin, real depthEnd)
{
  March march = beginMarch(depthBegin);
  Traversal traversal = traversalFrom(ray, depthBegin);
  marchOn(ray, thicknessPerDepth, depthEnd, traversal, march);
  return march;
}
