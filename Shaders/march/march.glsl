// The march: from where a ray enters the mesh, from tetrahedron to tetrahedron, to where it ends.

struct March
{
  Radiance radiance;
  real done;       // depth up to which the ray has gathered; nothing is gathered twice
  bool finished;   // opaque, or past the last depth that is asked for
  int cells;       // tetrahedra crossed
#if TETMARCH_SAMPLED_SHADOWS
  bool paused;     // to look how much light comes; marchToExit() goes on from there,
  bool left;       // unless nothing of the way is left
  real nextSample; // the transmittance at which that is due
  Tet last;        // that was crossed
  real seenDepth;  // where in it is on the average what is seen of it
#endif
#if TETMARCH_PICKED
  real target;     // what a ray has gathered where it is picked
  Pick pick;
#endif
#if TETMARCH_DIAGNOSTICS
  int lookups; // lookups of the segment integral
  int refused;     // entry faces that refused the ray
  int lost;        // tetrahedra without an exit
  int guarded;     // marches stopped by the step guard
#endif
};

March beginMarch(real depthBegin)
{
  March march;
  march.radiance = noRadiance();
  march.done = depthBegin;
  march.finished = false;
  march.cells = 0;
#if TETMARCH_SAMPLED_SHADOWS
  march.paused = false;
  march.left = false;
  march.nextSample = real(-1); // never
#endif
#if TETMARCH_PICKED
  march.target = NO_DEPTH; // nowhere
  march.pick = noPick();
#endif
#if TETMARCH_DIAGNOSTICS
  march.lookups = 0;
  march.refused = 0;
  march.lost = 0;
  march.guarded = 0;
#endif
  return march;
}

#if TETMARCH_SAMPLED_SHADOWS
// How far into an even piece lies on the average what is seen of it, of the transmittance before and behind it: by its
// optical depth D, 1 / D - 1 / (exp(D) - 1), a half in a thin one.
real seenShare(real before, real behind)
{
  real absorbed = (before - behind) / max(before, TINY);
  real depth = -log(max(real(1) - absorbed, TINY));
  real thin = real(0.5) - depth * (real(1) / real(12));
  return depth < real(0.05) ? thin : real(1) / depth - (real(1) - absorbed) / max(absorbed, TINY);
}
#endif

// Step through the tetrahedron behind the face. Returns whether the ray goes on behind it.
bool passCell(Ray ray, real depthEnd, INOUT(FaceIntersection) face, INOUT(uvec2) link, INOUT(CellInterval) cell, INOUT(March) march)
{
#if TETMARCH_ISOSURFACES
#if TETMARCH_CROPPED
  real end = cell.rest;
#else
  real end = cell.end;
#endif
  cell.before = cell.drawn ? vec2(end, cell.scalar) : cell.before;
#endif
  cell.tet = link.x;
  cell.enter = cell.leave;
  vec4 apex = fetchVertex(link.y);
#if TETMARCH_SAMPLED_SHADOWS
  march.last.number = link.x;
  march.last.a = face.id.x;
  march.last.b = face.id.y;
  march.last.c = face.id.z;
  march.last.d = link.y;
#endif
  int exitFace = stepThrough(face, link.y, project(ray, vec3(apex.x, apex.y, apex.z)), apex.w);
  cell.leave = intersectionPoint(face);
#if TETMARCH_COMPONENTS && TETMARCH_POINT_SCALARS
  cell.furtherEnter = cell.furtherLeave;
  cell.furtherLeave = furtherAt(face);
#endif
  link = fetchLink(4u * cell.tet + uint(max(exitFace, 0)));
  march.cells = march.cells + 1;

  // An inverted tetrahedron is left before it is entered; overlaps are cut off likewise.
  cell.begin = max(cell.enter.x, march.done);
  cell.end = min(cell.leave.x, depthEnd);
  bool forward = cell.end > cell.begin;
#if TETMARCH_POINT_SCALARS
  cell.scalar = cell.leave.y;
  real first = cell.enter.y;
#else
  cell.scalar = fetchCellScalar(cell.tet);
  real first = cell.scalar;
#endif
#if TETMARCH_HIDDEN_CELLS
  bool open = forward && !isHidden(cell.tet);
#else
  bool open = forward;
#endif
  cell.seen = open && isDrawn(first) && isDrawn(cell.scalar);
#if TETMARCH_TRANSPARENT_RANGES
  cell.seen = cell.seen &&
    !isTransparentBetween(first * tableScale + tableOffset, cell.scalar * tableScale + tableOffset);
#elif TETMARCH_ISOSURFACES
  cell.drawn = cell.seen;
  cell.seen = cell.drawn && crossesSurface(visibleSegment(cell));
#endif
#if TETMARCH_NAN_SHOWN
  cell.finite = isDrawn(first) && isDrawn(cell.scalar);
  cell.seen = cell.finite ? cell.seen : open && nanColor.w > real(0);
#endif
  // Of a piece that was passed backwards nothing is done yet.
  march.done = forward ? cell.end : march.done;
  march.finished = max(cell.begin, cell.end) >= depthEnd;
#if TETMARCH_TRACED
  traceCell(cell, march);
#endif
#if TETMARCH_CROPPED
  cell.rest = cell.end;
  vec2 piece = nextSegment(ray, cell.begin, cell.seen ? cell.end : cell.begin);
  cell.begin = piece.x;
  cell.end = piece.y;
  cell.seen = cell.seen && piece.y > piece.x;
#endif
#if TETMARCH_DIAGNOSTICS
  march.lost = march.lost + (exitFace < 0 ? 1 : 0);
  march.guarded = march.guarded + (march.cells >= mostCells ? 1 : 0);
#endif
  return exitFace >= 0 && link.x < LINK_OUTSIDE && march.cells < mostCells && !march.finished;
}

// March from a boundary face to the boundary face through which the ray leaves the mesh, whose intersection and link
// take the place of the first one's. thicknessPerDepth is the length, in scalar opacity unit distances, of a unit of
// depth.
void marchToExit(
  Ray ray, INOUT(FaceIntersection) face, INOUT(uvec2) link, real thicknessPerDepth, real depthEnd, INOUT(March) march)
{
  CellInterval cell = beginCellInterval(ray, face, link.x);
  bool onward = true;
  while (onward)
  {
#if TETMARCH_PASSES_CELLS
    // What isn't seen is passed in a loop of its own. (As a do-while Mesa 22.3 compiles it wrong.)
    bool passing = true;
    while (passing)
    {
#endif
#if TETMARCH_EFFECTS
    beginCell(cell.shades, cell.seen);
#endif
    onward = passCell(ray, depthEnd, face, link, cell, march);
#if TETMARCH_EFFECTS
    cell.shades.to = facePoint(face, vec2(cell.leave.x, cell.scalar));
#endif
#if TETMARCH_PASSES_CELLS
      passing = onward && !cell.seen;
    }
#endif
#if TETMARCH_SAMPLED_SHADOWS
    real before = march.radiance.transmittance;
#endif
#if TETMARCH_EFFECTS
    shadeCell(ray, face, cell.tet, cell.shades);
#endif
#if TETMARCH_CROPPED
    bool cropping = cell.seen;
    while (cropping)
    {
#endif
#if TETMARCH_PICKED
    if (cell.seen)
    {
      pickSegment(thicknessPerDepth, march.target, cell, march.radiance, march.pick);
    }
#else
#if TETMARCH_NAN_SHOWN
    if (cell.seen && !cell.finite)
    {
      absorbNan(march.radiance, (cell.end - cell.begin) * thicknessPerDepth);
    }
    if (cell.seen && cell.finite)
#else
    if (cell.seen)
#endif
    {
      int trials = gatherSegment(visibleSegment(cell), thicknessPerDepth, cell, march.radiance);
#if TETMARCH_DIAGNOSTICS
      march.lookups = march.lookups + trials;
#endif
    }
#endif
#if TETMARCH_CROPPED
      vec2 piece = nextSegment(ray, cell.end, cell.rest);
      cropping = piece.y > piece.x;
      cell.begin = cropping ? piece.x : cell.begin;
      cell.end = cropping ? piece.y : cell.end;
    }
#endif
#if TETMARCH_PICKED
    march.finished = march.finished || march.pick.hit;
#else
    march.finished = march.finished || isOpaque(march.radiance);
#endif
    onward = onward && !march.finished;
#if TETMARCH_SAMPLED_SHADOWS
    march.seenDepth = cell.begin + (cell.end - cell.begin) * seenShare(before, march.radiance.transmittance);
    march.left = !onward;
    march.paused = march.radiance.transmittance <= march.nextSample;
    onward = onward && !march.paused;
#endif
  }
}

// To the end of the ray, or up to where the march pauses.
void marchOn(Ray ray, real thicknessPerDepth, real depthEnd, INOUT(Traversal) traversal, INOUT(March) march)
{
  while (continuesBefore(traversal, depthEnd) && march.cells < mostCells)
  {
    enterMesh(ray, traversal);
#if TETMARCH_SAMPLED_SHADOWS
    bool onward = traversal.entered && !march.left;
#else
    bool onward = traversal.entered;
#endif
    if (onward)
    {
      marchToExit(ray, traversal.face, traversal.link, thicknessPerDepth, depthEnd, march);
    }
#if TETMARCH_SAMPLED_SHADOWS
    if (march.paused)
    {
      return;
    }
    march.left = false;
#endif
#if TETMARCH_DIAGNOSTICS
    march.refused = march.refused + (traversal.entered ? 0 : 1);
#endif
    leaveMesh(ray, march.finished, traversal);
  }
}
