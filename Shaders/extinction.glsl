// How much light comes along a ray: a march that knows extinction alone. It adds up optical depth from tetrahedron to
// tetrahedron; the transmittance is one exponential at the end. What tables say of colours is left out by compilers.

struct Attenuation
{
  real depth;    // optical
  real done;     // depth of the ray up to which it is integrated; nothing is integrated twice
  bool finished; // dark, or past the last depth that is asked for
  int cells;     // tetrahedra crossed
};

#if TETMARCH_INDEPENDENT && TETMARCH_POINT_SCALARS
// Mean extinction between two depths in a tetrahedron that the ray enters and leaves at points (depth, scalar).
real extinctionBetween(vec2 enter, vec2 leave, vec3 furtherEnter, vec3 furtherLeave, vec2 range)
{
  vec4 from = scalarsOf(enter.y, furtherEnter);
  vec4 to = scalarsOf(leave.y, furtherLeave);
  real begin = range.x > enter.x ? shareAt(enter, leave, range.x) : real(0);
  real end = range.y < leave.x ? shareAt(enter, leave, range.y) : real(1);
  Mixture mixture = mixtureBetween(from + (to - from) * begin, from + (to - from) * end);
  return isDrawn(enter.y) && isDrawn(leave.y) ? mixture.mean.w : real(0);
}
#elif TETMARCH_INDEPENDENT
real extinctionOf(uint tet)
{
  real scalar = fetchCellScalar(tet);
  vec4 mean = mixtureAt(scalarsOf(scalar, fetchFurtherScalars(tet)));
  return isDrawn(scalar) ? mean.w : real(0);
}
#elif TETMARCH_POINT_SCALARS
// Mean extinction between two depths in a tetrahedron that the ray enters and leaves at points (depth, scalar). `at` is
// the table at the last end, which is mostly this begin; where it isn't, the first turn only reads the table there.
real extinctionBetween(vec2 enter, vec2 leave, vec2 range, INOUT(TablePoint) at)
{
  real scalarBegin = range.x > enter.x ? scalarAt(enter, leave, range.x) : enter.y;
  real scalarEnd = range.y < leave.x ? scalarAt(enter, leave, range.y) : leave.y;
  real begin = scalarBegin * tableScale + tableOffset;
  real end = scalarEnd * tableScale + tableOffset;
  bool loaded = at.x == begin;
  real mean = real(0);
  bool pending = true;
  do
  {
    TablePoint next = tablePoint(loaded ? end : begin);
    mean = meanBetween(at, next).w;
    at = next;
    pending = !loaded;
    loaded = true;
  } while (pending);
  return isDrawn(enter.y) && isDrawn(leave.y) ? mean : real(0);
}
#else
real extinctionOf(uint tet)
{
  real scalar = fetchCellScalar(tet);
  return isDrawn(scalar) ? tableValue(scalar * tableScale + tableOffset).w : real(0);
}
#endif

#if TETMARCH_GRADIENT_OPACITY && TETMARCH_VERTEX_GRADIENTS
real densityAt(Crossing face) { return gradientOpacity(gradientAt(face, crossingShares(face))); }

// In the middle between two depths in a tetrahedron, by what it is where the ray enters and leaves.
real densityBetween(vec2 enter, vec2 leave, vec2 range, real atEnter, real atLeave)
{
  real begin = range.x > enter.x ? shareAt(enter, leave, range.x) : real(0);
  real end = range.y < leave.x ? shareAt(enter, leave, range.y) : real(1);
  return atEnter + (atLeave - atEnter) * ((begin + end) * real(0.5));
}
#endif

#if TETMARCH_NAN_SHOWN
bool isFinite(uint tet, vec2 enter, vec2 leave)
{
#if TETMARCH_POINT_SCALARS
  return isDrawn(enter.y) && isDrawn(leave.y);
#else
  return isDrawn(fetchCellScalar(tet));
#endif
}
#endif

// Where the scalar is not finite there is another, and none in a hidden tetrahedron.
real countedExtinction(real extinction, uint tet, vec2 enter, vec2 leave)
{
#if TETMARCH_NAN_SHOWN
  extinction = isFinite(tet, enter, leave) ? extinction : nanColor.w;
#endif
#if TETMARCH_HIDDEN_CELLS
  extinction = isHidden(tet) ? real(0) : extinction;
#endif
  return extinction;
}

// From a face to the boundary face through which the ray leaves the mesh, as marchToExit() goes.
void attenuateToExit(Ray ray, INOUT(Crossing) face, INOUT(uvec2) link, real opticalLength, real depthEnd,
  INOUT(Attenuation) passed)
{
  real darkDepth = -log(errorTolerance);
  vec2 enter = crossingPoint(face);
#if TETMARCH_INDEPENDENT && TETMARCH_POINT_SCALARS
  fetchCorners(face);
  vec3 furtherEnter = furtherAt(face);
#elif TETMARCH_POINT_SCALARS
  TablePoint at = tablePoint(isDrawn(enter.y) ? enter.y * tableScale + tableOffset : tableOffset);
#endif
#if TETMARCH_GRADIENT_OPACITY && TETMARCH_VERTEX_GRADIENTS
  fetchCorners(face);
  real densityEnter = densityAt(face);
#endif
  bool onward = true;
  while (onward)
  {
    uint tet = link.x;
    vec4 apex = fetchVertex(link.y);
    int exitFace = stepThrough(face, link.y, project(ray, vec3(apex.x, apex.y, apex.z)), apex.w);
    vec2 leave = crossingPoint(face);
    link = fetchLink(4u * tet + uint(max(exitFace, 0)));
    passed.cells = passed.cells + 1;

    // An inverted tetrahedron is left before it is entered; overlaps are cut off likewise.
    vec2 range = vec2(max(enter.x, passed.done), min(leave.x, depthEnd));
    bool forward = range.y > range.x;
#if TETMARCH_INDEPENDENT && TETMARCH_POINT_SCALARS
    vec3 furtherLeave = furtherAt(face);
    real extinction = extinctionBetween(enter, leave, furtherEnter, furtherLeave, range);
    furtherEnter = furtherLeave;
#elif TETMARCH_POINT_SCALARS
    real extinction = extinctionBetween(enter, leave, range, at);
#else
    real extinction = extinctionOf(tet);
#endif
#if TETMARCH_GRADIENT_OPACITY && TETMARCH_VERTEX_GRADIENTS
    real densityLeave = densityAt(face);
    extinction = extinction * densityBetween(enter, leave, range, densityEnter, densityLeave);
    densityEnter = densityLeave;
#elif TETMARCH_GRADIENT_OPACITY
    extinction = extinction * gradientOpacity(fetchCellGradient(tet));
#endif
    extinction = countedExtinction(extinction, tet, enter, leave);
    passed.depth = passed.depth + (forward ? extinction * (range.y - range.x) * opticalLength : real(0));
    passed.done = forward ? range.y : passed.done;
    passed.finished = passed.depth > darkDepth || max(range.x, range.y) >= depthEnd;
    enter = leave;
    onward = exitFace >= 0 && link.x < LINK_OUTSIDE && passed.cells < mostCells && !passed.finished;
  }
}

// On all ways of the ray between two depths.
Attenuation attenuate(Ray ray, real opticalLength, real depthBegin, real depthEnd, INOUT(Way) way)
{
  Attenuation passed;
  passed.depth = real(0);
  passed.done = depthBegin;
  passed.finished = false;
  passed.cells = 0;
  while (leadsOn(way, depthEnd) && passed.cells < mostCells)
  {
    enterMesh(ray, way);
    if (way.entered)
    {
      attenuateToExit(ray, way.face, way.link, opticalLength, depthEnd, passed);
    }
    leaveMesh(ray, passed.finished, way);
  }
  return passed;
}

real transmittanceOn(Ray ray, real opticalLength, real depthBegin, real depthEnd, INOUT(Way) way)
{
  Attenuation passed = attenuate(ray, opticalLength, depthBegin, depthEnd, way);
  return exp(-passed.depth);
}
