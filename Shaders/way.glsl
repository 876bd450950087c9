// All the ways of a ray through the mesh, front to back, whatever is gathered on them.

// A ray under way: in the mesh before a face, or at an entry, which may refuse it.
struct Way
{
  Crossing face;
  uvec2 link; // of that face: what lies behind it
  bool inside; // face and link are known; else they are those of the entry
  bool entered;
  Entry entry;
};

// From the boundary face that the rasteriser or a search found, or from the first one.
Way wayFromBoundary(Ray ray, int firstFace)
{
  Way way;
  way.inside = false;
  way.entered = false;
  way.entry.depth = -NO_DEPTH;
  way.entry.face = firstFace;
#if TETMARCH_BVH
  if (firstFace < 0)
  {
    way.entry = nextEntry(ray, way.entry, true);
  }
#endif
  return way;
}

// Whether any of it lies before that depth.
bool leadsOn(Way way, real depthEnd) { return way.entry.face >= 0 && way.entry.depth < depthEnd; }

// In by the boundary face, unless the ray is inside already.
void enterMesh(Ray ray, INOUT(Way) way)
{
  if (!way.inside)
  {
    way.link = fetchLink(4u * tetCount + uint(way.entry.face));
    way.entered = enters(ray, uint(way.entry.face), way.face);
    way.inside = true;
  }
}

// From the face by which the ray has left the mesh, or which refused it, to the next entry; to none if nothing more
// is asked for.
void leaveMesh(Ray ray, bool finished, INOUT(Way) way)
{
  way.inside = false;
#if TETMARCH_BVH
  // A ray that leaves the convex hull is done. But along a flat side of it rounding makes bumps, out of which a
  // ray may come before it gets in: then faces of the hull are looked at again.
  bool leftHull =
    way.entered && way.link.x >= LINK_OUTSIDE && int(way.link.x - LINK_OUTSIDE) >= reentryFaceCount;
  bool certain = isTurnedForSure(way.face);
  if (finished || (leftHull && certain))
  {
    way.entry.face = -1;
  }
  else
  {
    // A face that refused the ray leaves even the first entry to be found. The rasteriser knows the depth of
    // its entry no better than its depth buffer: behind such a one all others are looked for.
    way.entry = nextEntry(ray, way.entry, !way.entered || leftHull);
  }
#else
  way.entry.face = -1;
#endif
}
