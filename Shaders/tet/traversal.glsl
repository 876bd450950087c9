// The traversal of the mesh: a ray enters it, leaves it, and may enter again.

// Where a ray is: before a face.
struct Place
{
  FaceIntersection face;
  uvec2 link; // of that face: the tetrahedron and the apex behind it
};

// The state of a ray: inside the mesh, or at an entry, which may refuse it.
struct Traversal
{
  Place place;
  bool inside;    // the place is set; else the entry tells it
  bool entered;   // the face at the entry accepted the ray
  Entry entry;
};

// From the boundary face that the rasteriser found; if it is -1, from the first one that a search finds, wherever the
// ray begins to be seen.
Traversal traversalFrom(Ray ray, int firstFace, real depthBegin)
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

// Whether the ray enters the mesh before that depth.
bool continuesBefore(Traversal traversal, real depthEnd)
{
  return traversal.entry.face >= 0 && traversal.entry.depth < depthEnd;
}

// Enters by the boundary face, unless the ray is inside already.
void enterVolume(Ray ray, real depthEnd, INOUT(Traversal) traversal)
{
  if (!traversal.inside)
  {
    traversal.place.link = fetchLink(4u * tetCount + uint(traversal.entry.face));
    traversal.entered = enters(ray, uint(traversal.entry.face), traversal.place.face);
    traversal.inside = true;
  }
}

// From the face by which the ray has left the mesh, or which refused it, to the next entry; to none if the ray is
// finished.
void leaveVolume(Ray ray, bool finished, INOUT(Traversal) traversal)
{
  traversal.inside = false;
#if TETMARCH_BVH
  // A ray that leaves the convex hull is finished. But along a flat side of the hull rounding makes bumps, which a ray
  // may leave before it enters the rest: then the faces of the hull are searched again.
  bool leftHull =
    traversal.entered && traversal.place.link.x >= LINK_OUTSIDE && int(traversal.place.link.x - LINK_OUTSIDE) >= reentryFaceCount;
  bool certain = isTurnedForSure(traversal.place.face);
  if (finished || (leftHull && certain))
  {
    traversal.entry.face = -1;
  }
  else
  {
    // If the face refused the ray, even the first entry is yet to be found. The rasteriser knows the depth of its entry
    // no better than its depth buffer does, so that all entries behind it are searched.
    traversal.entry = nextEntry(ray, traversal.entry, !traversal.entered || leftHull);
  }
#else
  traversal.entry.face = -1;
#endif
}
