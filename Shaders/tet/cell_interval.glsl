// The way of a ray through a tetrahedron, and what is known where it comes in and leaves.

struct CellInterval
{
  uint tet;
  vec2 enter;  // depth and scalar where the ray comes in
  vec2 leave;
  real begin;  // depths of what is gathered of it
  real end;
  real scalar; // of the cell, or where the ray leaves
  bool seen;   // there is something to gather
#if TETMARCH_COMPOSITE && TETMARCH_POINT_SCALARS && !TETMARCH_INDEPENDENT
  TablePoint at; // the table where the ray was last
#endif
#if TETMARCH_COMPONENTS && TETMARCH_POINT_SCALARS
  vec3 furtherEnter; // scalars beside the first
  vec3 furtherLeave;
#endif
#if TETMARCH_EFFECTS
  CellShades shades;
#endif
#if TETMARCH_CROPPED
  real rest;   // behind the end, and up to here, there may be other pieces of it
#endif
#if TETMARCH_NAN_SHOWN
  bool finite; // the scalar is finite
#endif
#if TETMARCH_ISOSURFACES
  bool drawn;  // it has a scalar, whether or not that passes a value
  vec2 before; // depth and scalar where the ray has left what is drawn before it
#endif
};

// A part of it, from one point (depth, scalar) of the ray to another.
struct Segment
{
  vec2 begin;
  vec2 end;
#if TETMARCH_COMPONENTS
  vec3 furtherBegin; // scalars beside the first
#if TETMARCH_POINT_SCALARS
  vec3 furtherEnd;
#endif
#endif
};

#if TETMARCH_COMPONENTS && TETMARCH_POINT_SCALARS
vec3 furtherBetween(CellInterval cell, real depth)
{
  return cell.furtherEnter + (cell.furtherLeave - cell.furtherEnter) * shareAt(cell.enter, cell.leave, depth);
}
#endif

// All that is gathered of it.
Segment visibleSegment(CellInterval cell)
{
  Segment piece;
#if TETMARCH_POINT_SCALARS
  piece.begin = vec2(
    cell.begin, cell.begin > cell.enter.x ? scalarAt(cell.enter, cell.leave, cell.begin) : cell.enter.y);
  piece.end =
    vec2(cell.end, cell.end < cell.leave.x ? scalarAt(cell.enter, cell.leave, cell.end) : cell.leave.y);
#else
  piece.begin = vec2(cell.begin, cell.scalar);
  piece.end = vec2(cell.end, cell.scalar);
#endif
#if TETMARCH_COMPONENTS && TETMARCH_POINT_SCALARS
  piece.furtherBegin = cell.begin > cell.enter.x ? furtherBetween(cell, cell.begin) : cell.furtherEnter;
  piece.furtherEnd = cell.end < cell.leave.x ? furtherBetween(cell, cell.end) : cell.furtherLeave;
#elif TETMARCH_COMPONENTS
  piece.furtherBegin = fetchFurtherScalars(cell.tet);
#endif
#if TETMARCH_ISOSURFACES
  // Scalars of cells change between two of them; and where rounding has cut cells off, no value is passed twice.
  piece.begin = vec2(cell.begin, cell.begin <= cell.before.x ? cell.before.y : piece.begin.y);
#endif
  return piece;
}

#if TETMARCH_EFFECTS
// From where to where in the tetrahedron the piece lies: 0, 1 if all the traversal.
vec2 shareOf(CellInterval cell, Segment piece)
{
  return vec2(piece.begin.x > cell.enter.x ? shareAt(cell.enter, cell.leave, piece.begin.x) : real(0),
    piece.end.x < cell.leave.x ? shareAt(cell.enter, cell.leave, piece.end.x) : real(1));
}
#endif

// Before a face by which the ray comes into the mesh; next: the tetrahedron behind it.
CellInterval beginCellInterval(Ray ray, INOUT(FaceIntersection) face, uint next)
{
  CellInterval cell;
  cell.leave = intersectionPoint(face);
  cell.seen = false;
#if TETMARCH_COMPONENTS && TETMARCH_POINT_SCALARS
  fetchCorners(face);
  cell.furtherLeave = furtherAt(face);
#endif
#if TETMARCH_COMPOSITE && TETMARCH_POINT_SCALARS && !TETMARCH_INDEPENDENT
  // Not of an undrawn scalar: integrateSegment() meets what stands here.
  cell.at = tablePoint(isDrawn(cell.leave.y) ? cell.leave.y * tableScale + tableOffset : tableOffset);
#endif
#if TETMARCH_EFFECTS
#if TETMARCH_POINT_SCALARS
  cell.shades = beginShades(ray, face, cell.leave);
#else
  cell.shades = beginShades(ray, face, vec2(cell.leave.x, fetchCellScalar(next)));
#endif
#endif
#if TETMARCH_ISOSURFACES
  cell.drawn = false;
  cell.before = vec2(-NO_DEPTH, real(0));
#endif
  return cell;
}
