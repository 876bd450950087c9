// One ray of the picture, from the boundary face that the rasteriser or a search found, or, where that is -1, from
// the first one.
March castPlainRay(Ray ray, int firstFace, real thicknessPerDepth, real depthBegin, real depthEnd)
{
  March march = beginMarch(depthBegin);
  Traversal traversal = traversalFromBoundary(ray, firstFace);
  marchOn(ray, thicknessPerDepth, depthEnd, traversal, march);
  return march;
}
