// Shades along the interval of a ray in a tetrahedron. Without effects nothing is done.

#if TETMARCH_EFFECTS && !TETMARCH_KEEPS_SHADE
// The point where the ray enters the tetrahedron.
FacePoint enterPoint(CellInterval cell)
{
  FacePoint point;
  point.depth = cell.enter.x;
#if TETMARCH_POINT_SCALARS
  point.scalar = cell.enter.y;
#else
  point.scalar = cell.scalar;
#endif
#if TETMARCH_VERTEX_ATTRIBUTES
  point.attributes = cell.enterAttributes;
#endif
  return point;
}
#endif

#if TETMARCH_EFFECTS
// The point where the ray leaves it.
FacePoint leavePoint(CellInterval cell)
{
  FacePoint point;
  point.depth = cell.leave.x;
  point.scalar = cell.scalar;
#if TETMARCH_VERTEX_ATTRIBUTES
  point.attributes = cell.leaveAttributes;
#endif
  return point;
}
#endif

// Before the face by which the ray enters the mesh; next: the tetrahedron behind it.
void beginShades(Ray ray, uint next, INOUT(CellInterval) cell)
{
#if TETMARCH_KEEPS_SHADE
  cell.scalar = cellScalar(next, cell.leave);
  cell.shades.leave = shadeAtFace(ray, leavePoint(cell));
#endif
}

// Before cell becomes the next tetrahedron.
void advanceShades(INOUT(CellInterval) cell)
{
#if TETMARCH_VERTEX_GRADIENTS && TETMARCH_PASSES_CELLS
  cell.shades.enterKnown = cell.seen;
#endif
}

// Sets the shades at both ends of a tetrahedron; face: the one by which the ray leaves it.
void shadeCell(Ray ray, FaceIntersection face, INOUT(CellInterval) cell)
{
#if TETMARCH_VERTEX_GRADIENTS && TETMARCH_PASSES_CELLS
  // The shade where the ray enters is that where it left the last tetrahedron, unless that was passed unseen.
  int missing = cell.shades.enterKnown ? 1 : 2;
  do
  {
    FacePoint point = leavePoint(cell);
    if (missing > 1)
    {
      point = enterPoint(cell);
    }
    cell.shades.enter = cell.shades.leave;
    cell.shades.leave = shadeAtFace(ray, point);
    missing = missing - 1;
  } while (missing > 0);
#elif TETMARCH_VERTEX_GRADIENTS
  cell.shades.enter = cell.shades.leave;
  cell.shades.leave = shadeAtFace(ray, leavePoint(cell));
#elif TETMARCH_EFFECTS
  // One gradient, and the light in the middle.
  FacePoint from = enterPoint(cell);
  FacePoint to = leavePoint(cell);
  real depth = real(0.5) * (from.depth + to.depth);
  real scalar = real(0.5) * (from.scalar + to.scalar);
  cell.shades.enter = shadeOf(ray, depth, scalar, fetchCellGradient(cell.tet),
    (incomingAt(ray, from) + incomingAt(ray, to)) * real(0.5));
  cell.shades.leave = cell.shades.enter;
#endif
#if TETMARCH_LIGHT_ERROR && TETMARCH_VERTEX_LIGHT
  cell.shades.interpolationError = lightInterpolationError(face);
#endif
}

#if TETMARCH_ACCUMULATES_OPACITY
// Before a segment of the tetrahedron is gathered.
void placeShades(Segment segment, INOUT(CellInterval) cell)
{
#if TETMARCH_EFFECTS
  cell.shades.within = rangeWithin(cell, segment);
#endif
}
#endif
