// All the ways of a ray through the mesh, front to back, whatever is gathered on them.

// A ray under way: in the mesh before a face, or at an entry, which may refuse it.
struct Traversal
{
  FaceIntersection face;
  uvec2 link; // of that face: what lies behind it
  bool inside; // face and link are known; else they are those of the entry
  bool entered;
  Entry entry;
};

// From the boundary face that the rasteriser or a search found, or from the first one.
Traversal traversalFromBoundary(Ray ray, int firstFace)
{
  Traversal traversal;
  traversal.inside = false;
  traversal.entered = false;
  traversal.entry.depth = -NO_DEPTH;
  traversal.entry.face = firstFace;
#if TETMARCH_BVH
  if (firstFace < 0)
  {
    traversal.entry = nextEntry(ray, traversal.entry, true);
  }
#endif
  return traversal;
}

// Whether any of it lies before that depth.
bool continuesBefore(Traversal traversal, real depthEnd) { return traversal.entry.face >= 0 && traversal.entry.depth < depthEnd; }

// In by the boundary face, unless the ray is inside already.
void enterMesh(Ray ray, INOUT(Traversal) traversal)
{
  if (!traversal.inside)
  {
    traversal.link = fetchLink(4u * tetCount + uint(traversal.entry.face));
    traversal.entered = enters(ray, uint(traversal.entry.face), traversal.face);
    traversal.inside = true;
  }
}

// From the face by which the ray has left the mesh, or which refused it, to the next entry; to none if nothing more
// is asked for.
void leaveMesh(Ray ray, bool finished, INOUT(Traversal) traversal)
{
  traversal.inside = false;
#if TETMARCH_BVH
  // A ray that leaves the convex hull is done. But along a flat side of it rounding makes bumps, out of which a
  // ray may come before it gets in: then faces of the hull are looked at again.
  bool leftHull =
    traversal.entered && traversal.link.x >= LINK_OUTSIDE && int(traversal.link.x - LINK_OUTSIDE) >= reentryFaceCount;
  bool certain = isTurnedForSure(traversal.face);
  if (finished || (leftHull && certain))
  {
    traversal.entry.face = -1;
  }
  else
  {
    // A face that refused the ray leaves even the first entry to be found. The rasteriser knows the depth of
    // its entry no better than its depth buffer: behind such a one all others are looked for.
    traversal.entry = nextEntry(ray, traversal.entry, !traversal.entered || leftHull);
  }
#else
  traversal.entry.face = -1;
#endif
}
