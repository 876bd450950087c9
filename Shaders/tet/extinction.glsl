// The transmittance of a ray towards the light: a march that integrates only extinction. It sums the optical depth over
// tetrahedra; the transmittance is one exponential at the end. Compilers eliminate the tables' colours.

struct ExtinctionMarch
{
  real opticalDepth;
  real done;     // depth up to which the ray is integrated; no part is integrated twice
  bool finished; // almost no light is left, or the ray is beyond its last depth
  int cells;     // tetrahedra crossed
};

#if TETMARCH_POINT_SCALARS
// Mean extinction between two depths in a tetrahedron that the ray enters and leaves at points (depth, scalar). `at` is
// the table at the end of the last lookup, which is usually this begin; if it is not, the first of two iterations only
// reads the table there.
#if TETMARCH_KEEPS_EXTINCTION_POINT
real extinctionBetween(vec2 enter, vec2 leave, vec2 range, INOUT(TablePoint) at)
#else
real extinctionBetween(vec2 enter, vec2 leave, vec2 range)
#endif
{
  real scalarBegin = range.x > enter.x ? scalarAt(enter, leave, range.x) : enter.y;
  real scalarEnd = range.y < leave.x ? scalarAt(enter, leave, range.y) : leave.y;
  real begin = scalarBegin * tableScale + tableOffset;
  real end = scalarEnd * tableScale + tableOffset;
#if TETMARCH_KEEPS_EXTINCTION_POINT
  int unread = at.x == begin ? 1 : 2;
  real mean = real(0);
  do
  {
    TablePoint next = tablePoint(unread > 1 ? begin : end);
    mean = meanBetween(at, next).mean.w;
    at = next;
    unread = unread - 1;
  } while (unread > 0);
#else
  real mean = meanOver(begin, end).mean.w;
#endif
  return isDrawn(enter.y) && isDrawn(leave.y) ? mean : real(0);
}
#else
real extinctionOf(uint tet)
{
  real scalar = fetchCellScalar(tet);
  return isDrawn(scalar) ? tableValue(scalar * tableScale + tableOffset).w : real(0);
}
#endif

#if TETMARCH_DENSITY_OF_FACES
// The factor of the extinction at a face intersection.
real densityAt(FaceIntersection face) { return gradientOpacity(attributesAt(face).gradient); }

// The same in the middle between two depths in a tetrahedron, from the factors at its entry and exit.
real densityBetween(vec2 enter, vec2 leave, vec2 range, real atEnter, real atLeave)
{
  real begin = range.x > enter.x ? fractionAt(enter, leave, range.x) : real(0);
  real end = range.y < leave.x ? fractionAt(enter, leave, range.y) : real(1);
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

// If the scalar is not finite the extinction is that of nanColor; in a hidden tetrahedron it is 0.
real cellExtinction(real extinction, uint tet, vec2 enter, vec2 leave)
{
#if TETMARCH_NAN_SHOWN
  extinction = isFinite(tet, enter, leave) ? extinction : nanColor.w;
#endif
#if TETMARCH_HIDDEN_CELLS
  extinction = isHidden(tet) ? real(0) : extinction;
#endif
  return extinction;
}

// The face between two tetrahedra, as far as the second one needs it.
struct ExtinctionFace
{
  vec2 enter; // depth and scalar
#if TETMARCH_KEEPS_EXTINCTION_POINT
  TablePoint at;
#endif
#if TETMARCH_DENSITY_OF_FACES
  real density;
#endif
};

// Adds the tetrahedron ahead. Returns whether the ray goes on.
bool passTet(Ray ray, real thicknessPerDepth, real depthEnd, real darkDepth, INOUT(RayPosition) place,
  INOUT(ExtinctionFace) face, INOUT(ExtinctionMarch) march)
{
  uint tet = place.side.ahead >> 2u;
  EnteredTet ahead = tetAhead(place);
#if TETMARCH_CORNER_SCALARS
  face.enter = enterTet(ahead, place);
#endif
  vec2 enter = face.enter;
  int exitFace = stepThrough(ray, ahead, place);
  vec2 leave = intersectionPoint(place.face);
  march.cells = march.cells + 1;

  // An inverted tetrahedron is left before it is entered; overlaps are cut off likewise.
  vec2 range = vec2(max(enter.x, march.done), min(leave.x, depthEnd));
  bool forward = range.y > range.x;
#if TETMARCH_KEEPS_EXTINCTION_POINT
  real extinction = extinctionBetween(enter, leave, range, face.at);
#elif TETMARCH_POINT_SCALARS
  real extinction = extinctionBetween(enter, leave, range);
#else
  real extinction = extinctionOf(tet);
#endif
#if TETMARCH_DENSITY_OF_FACES
  real density = densityAt(place.face);
  extinction = extinction * densityBetween(enter, leave, range, face.density, density);
  face.density = density;
#elif TETMARCH_GRADIENT_OPACITY
  extinction = extinction * gradientOpacity(fetchCellGradient(tet));
#endif
  extinction = cellExtinction(extinction, tet, enter, leave);
  march.opticalDepth = march.opticalDepth + (forward ? extinction * (range.y - range.x) * thicknessPerDepth : real(0));
  march.done = forward ? range.y : march.done;
  march.finished = march.opticalDepth > darkDepth || max(range.x, range.y) >= depthEnd;
  face.enter = leave;
  return exitFace >= 0 && !isOutside(place.side.ahead) && !march.finished;
}

// Marches from a face to the boundary face through which the ray leaves the mesh, like marchToExit().
void marchExtinctionToExit(
  Ray ray, INOUT(RayPosition) place, real thicknessPerDepth, real depthEnd, INOUT(ExtinctionMarch) march)
{
  real darkDepth = -log(errorTolerance);
  ExtinctionFace face;
  face.enter = intersectionPoint(place.face);
#if TETMARCH_KEEPS_EXTINCTION_POINT
  face.at = tablePoint(isDrawn(face.enter.y) ? face.enter.y * tableScale + tableOffset : tableOffset);
#endif
  fetchCorners(place.face);
  placeOnPath(place.side, place.face);
  lookAhead(place);
#if TETMARCH_DENSITY_OF_FACES
  face.density = densityAt(place.face);
#endif
  bool onward = true;
  while (onward && march.cells < mostSteps)
  {
    onward = passTet(ray, thicknessPerDepth, depthEnd, darkDepth, place, face, march);
#if TETMARCH_COUNTS_TURNS
    // Two a turn: fewer rays reach the limit, and end early.
    if (onward)
    {
      onward = passTet(ray, thicknessPerDepth, depthEnd, darkDepth, place, face, march);
    }
#endif
  }
}

#if TETMARCH_COUNTS_TURNS
CONSTANT int TURNS_OF_SEARCH = 6; // about, for the next entry
#endif

// Marches the ray between two depths.
ExtinctionMarch marchExtinction(
  Ray ray, real thicknessPerDepth, real depthBegin, real depthEnd, INOUT(Traversal) traversal)
{
  ExtinctionMarch march;
  march.opticalDepth = real(0);
  march.done = depthBegin;
  march.finished = false;
  march.cells = 0;
  int entries = 0;
  while (continuesBefore(traversal, depthEnd) && march.cells < mostSteps && entries < mostSteps)
  {
    entries = entries + 1;
    enterBySearch(ray, traversal);
    if (traversal.entered)
    {
      marchExtinctionToExit(ray, traversal.place, thicknessPerDepth, depthEnd, march);
    }
    leaveBySearch(ray, march.finished, traversal);
  }
#if TETMARCH_COUNTS_TURNS
  countTurns(march.cells / 2 + (1 + TURNS_OF_SEARCH) * entries);
#endif
  return march;
}

real transmittanceOn(Ray ray, real thicknessPerDepth, real depthBegin, real depthEnd, INOUT(Traversal) traversal)
{
  ExtinctionMarch march = marchExtinction(ray, thicknessPerDepth, depthBegin, depthEnd, traversal);
  return exp(-march.opticalDepth);
}
