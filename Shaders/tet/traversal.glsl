// The traversal of the mesh: a ray enters it, leaves it, and may reenter.

// A tetrahedron that a ray enters through a face, and its fourth vertex.
struct EnteredTet
{
  uvec4 cell;
  uint apexId;
  vec4 apex; // position, scalar
};

// The position of a ray: before a face.
struct RayPosition
{
  FaceIntersection face;
  Side side; // of that face
#if TETMARCH_LOOKS_AHEAD
  EnteredTet ahead; // set by lookAhead()
#endif
#if TETMARCH_CORNER_SCALARS
  real apexScalar; // of the tetrahedron ahead; set by enterTet()
#endif
};

uint apexAhead(uvec4 cell, Side side, FaceIntersection face)
{
#if TETMARCH_JOINED_SIDES
  return vertexOnPath(side, apexOnPath(face.onPath));
#else
  return apexOf(cell, side, face.id);
#endif
}

// At the first face inside of the mesh, and at each further one: reads the tetrahedron ahead, or any if the face is the
// last one.
void lookAhead(INOUT(RayPosition) place)
{
#if TETMARCH_LOOKS_AHEAD
  bool outside = isOutside(place.side.ahead);
  Side ahead = place.side;
  ahead.ahead = outside ? 0u : ahead.ahead;
  place.ahead.cell = cellAhead(ahead);
  place.ahead.apexId = outside ? place.face.id.x : apexAhead(place.ahead.cell, ahead, place.face);
  place.ahead.apex = fetchVertex(place.ahead.apexId);
#endif
}

EnteredTet tetAhead(RayPosition place)
{
#if TETMARCH_LOOKS_AHEAD
  return place.ahead;
#else
  EnteredTet tet;
  tet.cell = cellAhead(place.side);
  tet.apexId = apexAhead(tet.cell, place.side, place.face);
  tet.apex = fetchVertex(tet.apexId);
  return tet;
#endif
}

#if TETMARCH_CORNER_SCALARS
// Before stepThrough(): the scalars at the face become those of the tetrahedron ahead. Returns depth and scalar of the
// ray there.
vec2 enterTet(EnteredTet tet, INOUT(RayPosition) place)
{
  place.apexScalar =
    takeCornerScalars(fetchCornerScalars(place.side.ahead >> 2u), tet.apexId, place.face);
  return intersectionPoint(place.face);
}
#endif

// Steps through the tetrahedron ahead: the place becomes that before the ray's exit face. Returns the index of that
// face in the tetrahedron, or -1 like replaceByExit().
int stepThrough(Ray ray, EnteredTet tet, INOUT(RayPosition) place)
{
#if TETMARCH_CORNER_SCALARS
  real scalar = place.apexScalar;
#else
  real scalar = tet.apex.w;
#endif
  vec3 apex = project(ray, vec3(tet.apex.x, tet.apex.y, tet.apex.z));
  int exitFace = replaceByExit(place.face, tet.apexId, apex, scalar);
  place.side = sideBehind(tet.cell, place.side, uint(max(exitFace, 0)));
  lookAhead(place);
  return exitFace;
}

// The state of a ray: inside the mesh, or at an entry, which may refuse it.
struct Traversal
{
  RayPosition place;
  bool inside;    // the place is set; else it follows from the entry
  bool entered;   // the face at the entry accepted the ray
  Entry entry;
#if TETMARCH_ENTRY_LISTS
  int candidate;  // entries behind the current one do not come before this index in the ray's list
#endif
};

#if TETMARCH_VISITS
// The traversal at a known entry, and the candidate after which the next one is searched.
Traversal traversalAt(Entry entry, int candidate)
{
  Traversal traversal;
  traversal.inside = false;
  traversal.entered = false;
  traversal.entry = entry;
#if TETMARCH_ENTRY_LISTS
  traversal.candidate = candidate;
#endif
  return traversal;
}

// The candidate for traversalAt().
int candidateOf(Traversal traversal)
{
#if TETMARCH_ENTRY_LISTS
  return traversal.candidate;
#else
  return 0;
#endif
}
#endif

#if TETMARCH_ENTRY_LISTS || TETMARCH_BVH
// The traversal before the first entry of the ray, for any begin of the visible part.
Traversal traversalFrom(Ray ray, real depthBegin)
{
  Traversal traversal;
  traversal.inside = false;
  traversal.entered = false;
  traversal.entry.depth = -NO_DEPTH;
  traversal.entry.face = -1;
#if TETMARCH_ENTRY_LISTS
  traversal.candidate = ray.firstCandidate;
  traversal.entry = nextCandidate(ray, traversal.entry, traversal.candidate);
#else
  traversal.entry = nextEntry(ray, traversal.entry, true);
#endif
  return traversal;
}
#endif

// Whether the ray enters the mesh before that depth.
bool continuesBefore(Traversal traversal, real depthEnd)
{
  return traversal.entry.face >= 0 && traversal.entry.depth < depthEnd;
}

#if TETMARCH_BVH || TETMARCH_SAMPLED_SHADOWS || !TETMARCH_ENTRY_LISTS
// Enters through the boundary face, unless the ray is already inside.
void enterBySearch(Ray ray, INOUT(Traversal) traversal)
{
  if (!traversal.inside)
  {
    uint face = uint(traversal.entry.face);
    traversal.place.side = sideFrom(LINK_OUTSIDE + face, fetchBoundaryFace(face).w);
    traversal.entered = enters(ray, face, traversal.place.face);
    traversal.inside = true;
  }
}
#endif

// The ray of a pixel enters through the face of its entry, unless it is already inside.
void enterVolume(Ray ray, real depthEnd, INOUT(Traversal) traversal)
{
#if TETMARCH_ENTRY_LISTS
  if (!traversal.inside)
  {
    traversal.place.side = sideOfListed(uint(traversal.entry.face));
    traversal.entered = entersListed(ray, uint(traversal.entry.face), traversal.place.face);
    traversal.inside = true;
  }
#else
  enterBySearch(ray, traversal);
#endif
}

#if TETMARCH_BVH || TETMARCH_SAMPLED_SHADOWS || !TETMARCH_ENTRY_LISTS
// From the exit face of any ray to its next entry, searched in the hierarchy; to none if the ray is finished, or if the
// mesh is convex and has no hierarchy.
void leaveBySearch(Ray ray, bool finished, INOUT(Traversal) traversal)
{
  traversal.inside = false;
#if TETMARCH_BVH
  // A ray that leaves the convex hull is finished. But rounding makes a flat side of the hull bumpy, and a ray may
  // leave a bump before it enters the rest: then the faces of the hull are searched again.
  Side side = traversal.place.side;
  bool leftHull = traversal.entered && isOutside(side.ahead) && boundaryFaceAhead(side) >= reentryFaceCount;
  bool certain = isTurnedForSure(traversal.place.face);
  if (finished || (leftHull && certain))
  {
    traversal.entry.face = -1;
  }
  else
  {
    traversal.entry = nextEntry(ray, traversal.entry, leftHull);
  }
#else
  traversal.entry.face = -1;
#endif
}
#endif

// From the exit face of a pixel's ray to its next entry; to none if the ray is finished.
void leaveVolume(Ray ray, bool finished, INOUT(Traversal) traversal)
{
#if TETMARCH_ENTRY_LISTS
  traversal.inside = false;
  if (finished)
  {
    traversal.entry.face = -1;
  }
  else
  {
    traversal.entry = nextCandidate(ray, traversal.entry, traversal.candidate);
  }
#else
  leaveBySearch(ray, finished, traversal);
#endif
}
