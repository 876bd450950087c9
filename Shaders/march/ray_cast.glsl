// One ray of the picture. firstFace is the boundary face by which the ray enters the mesh; if it is -1, a search finds
// the first one.
March castPlainRay(Ray ray, int firstFace, real thicknessPerDepth, real depthBegin, real depthEnd)
{
  March march = beginMarch(depthBegin);
  Traversal traversal = traversalFrom(ray, firstFace, depthBegin);
  marchOn(ray, thicknessPerDepth, depthEnd, traversal, march);
  return march;
}
