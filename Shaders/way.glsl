// All the ways of a ray through the mesh, front to back.

// A ray under way: in the mesh before a face, or at an entry, which may refuse it.
struct Way
{
  Crossing face;
  uvec2 link; // of that face: what lies behind it
  bool inside; // face and link are known; else they are those of the entry
  bool entered;
#if TETMARCH_BVH
  Entry entry;
#else
  int firstFace;
#endif
};

// One way through the mesh: in by the boundary face, unless the ray is inside already, and on to where it leaves.
void marchWay(
  Ray ray, int boundaryFace, real opticalLength, real depthEnd, INOUT(Way) way, INOUT(March) march)
{
  if (!way.inside)
  {
    way.link = fetchLink(4u * tetCount + uint(boundaryFace));
    way.entered = enters(ray, uint(boundaryFace), way.face);
    way.inside = true;
  }
#if TETMARCH_SAMPLED_SHADOWS
  bool onward = way.entered && !march.left;
#else
  bool onward = way.entered;
#endif
  if (onward)
  {
    marchToExit(ray, way.face, way.link, opticalLength, depthEnd, march);
  }
}

// To the end of the ray, or up to where the march pauses.
void marchOn(Ray ray, real opticalLength, real depthEnd, INOUT(Way) way, INOUT(March) march)
{
#if TETMARCH_BVH
  while (way.entry.face >= 0 && way.entry.depth < depthEnd && march.cells < mostCells)
  {
    marchWay(ray, way.entry.face, opticalLength, depthEnd, way, march);
#if TETMARCH_SAMPLED_SHADOWS
    if (march.paused)
    {
      return;
    }
    march.left = false;
#endif
    // A ray that leaves the convex hull is done. But along a flat side of it rounding makes bumps, out of which a
    // ray may come before it gets in: then faces of the hull are looked at again.
    bool leftHull =
      way.entered && way.link.x >= LINK_OUTSIDE && int(way.link.x - LINK_OUTSIDE) >= reentryFaceCount;
    bool certain = isTurnedForSure(way.face);
#if TETMARCH_DIAGNOSTICS
    march.refused = march.refused + (way.entered ? 0 : 1);
#endif
    if (march.finished || (leftHull && certain))
    {
      way.entry.face = -1;
    }
    else
    {
      // A face that refused the ray leaves even the first entry to be found. The rasteriser knows the depth of
      // its entry no better than its depth buffer: behind such a one all others are looked for.
      way.entry = nextEntry(ray, way.entry, !way.entered || leftHull);
    }
    way.inside = false;
  }
#else
  marchWay(ray, way.firstFace, opticalLength, depthEnd, way, march);
#if TETMARCH_DIAGNOSTICS
  march.refused = march.refused + (way.entered ? 0 : 1);
#endif
#endif
}

// From the boundary face that the rasteriser or a search found, or from the first one.
Way wayFromBoundary(Ray ray, int firstFace)
{
  Way way;
  way.inside = false;
  way.entered = false;
#if TETMARCH_BVH
  way.entry.depth = -NO_DEPTH;
  way.entry.face = firstFace;
  if (firstFace < 0)
  {
    way.entry = nextEntry(ray, way.entry, true);
  }
#else
  way.firstFace = firstFace;
#endif
  return way;
}
