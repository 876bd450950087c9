// The march: from where a ray enters the mesh, from tetrahedron to tetrahedron, to where it ends.

struct March
{
  Radiance radiance;
  real done;       // depth up to which the ray is integrated; nothing is integrated twice
  bool finished;   // opaque, or past the last depth that is asked for
  int cells;       // tetrahedra crossed
#if TETMARCH_SAMPLED_SHADOWS
  bool paused;     // to look how much light comes; marchToExit() goes on from there,
  bool left;       // unless nothing of the way is left
  real nextSample; // the transmittance at which that is due
  Tet last;        // that was crossed
  real seenDepth;  // where in it is on the average what is seen of it
#endif
#if TETMARCH_DIAGNOSTICS
  int evaluations; // evaluations of the segment integral
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
#if TETMARCH_DIAGNOSTICS
  march.evaluations = 0;
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

// March from a boundary face to the boundary face through which the ray leaves the mesh, whose crossing and link
// take the place of the first one's. opticalLength is the length, in scalar opacity unit distances, of a unit of
// depth.
void marchToExit(
  Ray ray, INOUT(Crossing) face, INOUT(uvec2) link, real opticalLength, real depthEnd, INOUT(March) march)
{
  vec2 enter = crossingPoint(face);
#if TETMARCH_POINT_SCALARS
  // Not of an undrawn scalar, whose crossing may even be NaN: integrateSegment() meets what stands here.
  TablePoint at = tablePoint(isDrawn(enter.y) ? enter.y * tableScale + tableOffset : tableOffset);
#endif
#if TETMARCH_EFFECTS
  CellShades shades = beginShades(ray, face, enter);
#endif
  bool onward = true;
  while (onward)
  {
    uint tet = link.x;
    vec4 apex = fetchVertex(link.y);
#if TETMARCH_SAMPLED_SHADOWS
    march.last.number = tet;
    march.last.a = face.id.x;
    march.last.b = face.id.y;
    march.last.c = face.id.z;
    march.last.d = link.y;
    real before = march.radiance.transmittance;
#endif
    int exitFace = stepThrough(face, link.y, project(ray, vec3(apex.x, apex.y, apex.z)), apex.w);
    vec2 leave = crossingPoint(face);
    link = fetchLink(4u * tet + uint(max(exitFace, 0)));
    march.cells = march.cells + 1;

    // An inverted tetrahedron is left before it is entered; overlaps are cut off likewise.
    real begin = max(enter.x, march.done);
    real end = min(leave.x, depthEnd);
#if !TETMARCH_POINT_SCALARS
    real scalar = fetchCellScalar(tet);
#elif TETMARCH_EFFECTS
    real scalar = leave.y;
#endif
#if TETMARCH_EFFECTS
    shadeCell(ray, face, tet, scalar, enter, leave, vec2(begin, end), shades);
#endif
#if TETMARCH_POINT_SCALARS
    if (end > begin && isDrawn(enter.y) && isDrawn(leave.y))
    {
      real scalarBegin = begin > enter.x ? scalarAt(enter, leave, begin) : enter.y;
      real scalarEnd = end < leave.x ? scalarAt(enter, leave, end) : leave.y;
#if TETMARCH_EFFECTS
      int trials =
        integrateSegment(scalarBegin * tableScale + tableOffset, scalarEnd * tableScale + tableOffset,
          (end - begin) * opticalLength, shades, at, march.radiance);
#else
      int trials = integrateSegment(scalarBegin * tableScale + tableOffset,
        scalarEnd * tableScale + tableOffset, (end - begin) * opticalLength, at, march.radiance);
#endif
#if TETMARCH_DIAGNOSTICS
      march.evaluations = march.evaluations + trials;
#endif
    }
#else
    if (end > begin && isDrawn(scalar))
    {
#if TETMARCH_EFFECTS
      integrateConstant(scalar * tableScale + tableOffset, (end - begin) * opticalLength, shades,
        march.radiance);
#else
      integrateConstant(scalar * tableScale + tableOffset, (end - begin) * opticalLength, march.radiance);
#endif
#if TETMARCH_DIAGNOSTICS
      march.evaluations = march.evaluations + 1;
#endif
    }
#endif
    // Of a piece that was passed backwards nothing is done yet.
    march.done = end > begin ? end : march.done;
    march.finished = isOpaque(march.radiance) || max(begin, end) >= depthEnd;
    enter = leave;
    onward =
      exitFace >= 0 && link.x < LINK_OUTSIDE && march.cells < mostCells && !march.finished;
#if TETMARCH_SAMPLED_SHADOWS
    march.seenDepth = begin + (end - begin) * seenShare(before, march.radiance.transmittance);
    march.left = !onward;
    march.paused = march.radiance.transmittance <= march.nextSample;
    onward = onward && !march.paused;
#endif
#if TETMARCH_DIAGNOSTICS
    march.lost = march.lost + (exitFace < 0 ? 1 : 0);
    march.guarded = march.guarded + (march.cells >= mostCells ? 1 : 0);
#endif
  }
}

// To the end of the ray, or up to where the march pauses.
void marchOn(Ray ray, real opticalLength, real depthEnd, INOUT(Way) way, INOUT(March) march)
{
  while (leadsOn(way, depthEnd) && march.cells < mostCells)
  {
    enterMesh(ray, way);
#if TETMARCH_SAMPLED_SHADOWS
    bool onward = way.entered && !march.left;
#else
    bool onward = way.entered;
#endif
    if (onward)
    {
      marchToExit(ray, way.face, way.link, opticalLength, depthEnd, march);
    }
#if TETMARCH_SAMPLED_SHADOWS
    if (march.paused)
    {
      return;
    }
    march.left = false;
#endif
#if TETMARCH_DIAGNOSTICS
    march.refused = march.refused + (way.entered ? 0 : 1);
#endif
    leaveMesh(ray, march.finished, way);
  }
}
