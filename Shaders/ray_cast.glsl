// One ray of the picture: all its ways through the mesh, front to back.

// From the boundary face that the rasteriser or a search found, or from the first one behind `after`.
March castRay(Ray ray, int firstFace, real opticalLength, real depthBegin, real depthEnd)
{
  March march = beginMarch(depthBegin);
#if TETMARCH_BVH
  Entry entry;
  entry.depth = -NO_DEPTH;
  entry.face = firstFace;
  if (firstFace < 0)
  {
    entry = nextEntry(ray, entry, true);
  }
  while (entry.face >= 0 && entry.depth < depthEnd && march.cells < mostCells)
  {
    Crossing face;
    bool entered = enters(ray, uint(entry.face), face);
    if (entered)
    {
      marchToExit(ray, face, fetchLink(4u * tetCount + uint(entry.face)), opticalLength, depthEnd, march);
    }
#if TETMARCH_DIAGNOSTICS
    march.refused = march.refused + (entered ? 0 : 1);
#endif
    if (march.finished)
    {
      entry.face = -1;
    }
    else
    {
      // A face that refused the ray leaves even the first entry to be found. The rasteriser knows the depth of
      // its entry no better than its depth buffer: behind such a one all others are looked for.
      entry = nextEntry(ray, entry, !entered);
    }
  }
#else
  Crossing face;
  bool entered = enters(ray, uint(firstFace), face);
  if (entered)
  {
    marchToExit(ray, face, fetchLink(4u * tetCount + uint(firstFace)), opticalLength, depthEnd, march);
  }
#if TETMARCH_DIAGNOSTICS
  march.refused = march.refused + (entered ? 0 : 1);
#endif
#endif
  return march;
}
