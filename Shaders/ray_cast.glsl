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
    uvec2 link = fetchLink(4u * tetCount + uint(entry.face));
    bool entered = enters(ray, uint(entry.face), face);
    if (entered)
    {
      marchToExit(ray, face, link, opticalLength, depthEnd, march);
    }
    // A ray that leaves the convex hull is done. But along a flat side of it rounding makes bumps, out of which a
    // ray may come before it gets in: then faces of the hull are looked at again.
    bool leftHull = entered && link.x >= LINK_OUTSIDE && int(link.x - LINK_OUTSIDE) >= reentryFaceCount;
    bool certain = isTurnedForSure(face);
#if TETMARCH_DIAGNOSTICS
    march.refused = march.refused + (entered ? 0 : 1);
#endif
    if (march.finished || (leftHull && certain))
    {
      entry.face = -1;
    }
    else
    {
      // A face that refused the ray leaves even the first entry to be found. The rasteriser knows the depth of
      // its entry no better than its depth buffer: behind such a one all others are looked for.
      entry = nextEntry(ray, entry, !entered || leftHull);
    }
  }
#else
  Crossing face;
  uvec2 link = fetchLink(4u * tetCount + uint(firstFace));
  bool entered = enters(ray, uint(firstFace), face);
  if (entered)
  {
    marchToExit(ray, face, link, opticalLength, depthEnd, march);
  }
#if TETMARCH_DIAGNOSTICS
  march.refused = march.refused + (entered ? 0 : 1);
#endif
#endif
  return march;
}
