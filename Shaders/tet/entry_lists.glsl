// Entries of a pixel's ray, from the list of its tile of pixels. The list contains all faces through which the ray may
// enter, by ascending depth; the predicate selects among them. So the entry is the same as that found by a search.

// The list contains boundary faces of the mesh or of its visible part.

#if TETMARCH_VISIBLE_PART
bool entersListed(Ray ray, uint face, OUT(FaceIntersection) intersection)
{
  uvec4 listed = fetchVisibleFace(face);
  return entersFace(ray, uvec3(listed.x, listed.y, listed.z), intersection);
}

Side sideOfListed(uint face) { return sideFrom(fetchVisibleLink(face), fetchVisibleFace(face).w); }

bool isInVisiblePart(uint tet) { return (fetchVisibleTets(tet >> 5u) >> (tet & 31u) & 1u) != 0u; }
#else
bool entersListed(Ray ray, uint face, OUT(FaceIntersection) intersection) { return enters(ray, face, intersection); }
Side sideOfListed(uint face) { return sideFrom(LINK_OUTSIDE + face, fetchBoundaryFace(face).w); }
#endif

// Whether a candidate applies to the ray's pixel.
bool isForPixel(Ray ray, uint where)
{
  uint x = ray.pixelInTile & 15u;
  uint y = ray.pixelInTile >> 4u;
  return x >= (where & 15u) && x <= (where >> 4u & 15u) && y >= (where >> 8u & 15u) && y <= (where >> 12u & 15u);
}

// The first entry after the given one, among the candidates from the given index on, which becomes that of the first
// possible later entry.
Entry nextCandidate(Ray ray, Entry after, INOUT(int) candidate)
{
  Entry best;
  best.depth = NO_DEPTH;
  best.face = -1;
  // Depths of candidates are relative to a plane: units at the ray's origin, and units per unit of depth.
  vec3 plane = vec3(entryDepthPlane.x, entryDepthPlane.y, entryDepthPlane.z);
  real unitsAtOrigin = dot(plane, ray.origin) + entryDepthPlane.w;
  real unitsPerDepth = dot(plane, ray.direction);
  int end = ray.endOfCandidates;
  int bestAt = end;
  int later = end;
  int i = candidate;
  bool searching = true;
  while (searching && i < end)
  {
    uvec2 found = fetchEntryCandidate(i);
    bool isNear = best.face < 0 || real(found.y >> 16u) <= unitsAtOrigin + unitsPerDepth * best.depth;
    bool isTried = isNear && isForPixel(ray, found.y);
    int face = int(found.x);
    FaceIntersection intersection;
    bool entered = entersListed(ray, found.x, intersection) && isTried;
    real depth = intersectionPoint(intersection).x;
    bool isAfter = entered && face != after.face && !isBefore(depth, face, after);
    bool isBest = isAfter && isBefore(depth, face, best);
    // Entries behind the best one are tested again when the ray has left that one.
    later = min(later, isBest ? bestAt : (isAfter ? i : end));
    bestAt = isBest ? i : bestAt;
    best.depth = isBest ? depth : best.depth;
    best.face = isBest ? face : best.face;
    i = i + (isNear ? 1 : 0);
    searching = isNear;
  }
  candidate = min(later, i);
  return best;
}
