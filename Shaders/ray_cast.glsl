// One ray of the picture, from the boundary face that the rasteriser or a search found, or, where that is -1, from
// the first one.
March castPlainRay(Ray ray, int firstFace, real opticalLength, real depthBegin, real depthEnd)
{
  March march = beginMarch(depthBegin);
  Way way = wayFromBoundary(ray, firstFace);
  marchOn(ray, opticalLength, depthEnd, way, march);
  return march;
}
