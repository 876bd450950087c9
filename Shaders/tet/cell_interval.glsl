// The interval of a ray in a tetrahedron, and what is known at its ends.

struct CellInterval
{
  uint tet;
  vec2 enter;  // depth and scalar where the ray enters the tetrahedron
  vec2 leave;  // and where it leaves it
  real begin;  // depths between which the cell is gathered
  real end;
  real scalar; // of the cell, or where the ray leaves it
  bool seen;   // there is something to gather
#if TETMARCH_KEEPS_TABLE_POINT
  TablePoint at; // the table at the end of the last lookup
#endif
#if TETMARCH_VERTEX_ATTRIBUTES
  VertexAttributes enterAttributes; // interpolated
  VertexAttributes leaveAttributes;
#endif
#if TETMARCH_EFFECTS
  CellShades shades;
#endif
#if TETMARCH_CROPPED
  real rest;   // depth up to which more of the cell may be left by the cropping
#endif
#if TETMARCH_NAN_SHOWN
  bool finite; // the scalar is finite
#endif
#if TETMARCH_ISOSURFACES
  bool drawn;  // the cell has a scalar and is not hidden, whether or not a surface crosses it
  vec2 before; // depth and scalar where the ray left the last cell that is drawn
#endif
};

// The scalar of a tetrahedron, or that at the point (depth, scalar) where the ray leaves it.
real cellScalar(uint tet, vec2 leave)
{
#if TETMARCH_POINT_SCALARS
  return leave.y;
#else
  return fetchCellScalar(tet);
#endif
}

#if TETMARCH_FURTHER_VERTEX_SCALARS
vec3 furtherAt(CellInterval cell, real depth)
{
  return cell.enterAttributes.further +
    (cell.leaveAttributes.further - cell.enterAttributes.further) * fractionAt(cell.enter, cell.leave, depth);
}
#endif

// The segment between cell.begin and cell.end.
Segment visibleSegment(CellInterval cell)
{
  Segment segment;
#if TETMARCH_POINT_SCALARS
  segment.begin = vec2(
    cell.begin, cell.begin > cell.enter.x ? scalarAt(cell.enter, cell.leave, cell.begin) : cell.enter.y);
  segment.end =
    vec2(cell.end, cell.end < cell.leave.x ? scalarAt(cell.enter, cell.leave, cell.end) : cell.leave.y);
#else
  segment.begin = vec2(cell.begin, cell.scalar);
  segment.end = vec2(cell.end, cell.scalar);
#endif
#if TETMARCH_FURTHER_VERTEX_SCALARS
  segment.furtherBegin = cell.begin > cell.enter.x ? furtherAt(cell, cell.begin) : cell.enterAttributes.further;
  segment.furtherEnd = cell.end < cell.leave.x ? furtherAt(cell, cell.end) : cell.leaveAttributes.further;
#elif TETMARCH_COMPONENTS
  segment.furtherBegin = fetchFurtherScalars(cell.tet);
#endif
#if TETMARCH_ISOSURFACES
  // Scalars of cells change between two cells. Where rounding makes cells overlap, no value is crossed twice.
  segment.begin = vec2(cell.begin, cell.begin <= cell.before.x ? cell.before.y : segment.begin.y);
#endif
  return segment;
}

#if TETMARCH_EFFECTS
// Where in the tetrahedron a segment begins and ends: 0 and 1 if it is all of the interval.
vec2 rangeWithin(CellInterval cell, Segment segment)
{
  return vec2(segment.begin.x > cell.enter.x ? fractionAt(cell.enter, cell.leave, segment.begin.x) : real(0),
    segment.end.x < cell.leave.x ? fractionAt(cell.enter, cell.leave, segment.end.x) : real(1));
}
#endif

#if TETMARCH_ISOSURFACES
// Depth up to which the cell has been gathered.
real gatheredEnd(CellInterval cell)
{
#if TETMARCH_CROPPED
  return cell.rest;
#else
  return cell.end;
#endif
}
#endif

// Before the face by which the ray enters the mesh.
void beginCell(FaceIntersection face, INOUT(CellInterval) cell)
{
  cell.leave = intersectionPoint(face);
  cell.seen = false;
#if TETMARCH_VERTEX_ATTRIBUTES
  cell.leaveAttributes = attributesAt(face);
#endif
#if TETMARCH_ISOSURFACES
  cell.drawn = false;
  cell.before = vec2(-NO_DEPTH, real(0));
#endif
}

// There the last lookup is that of the table at the begin; not of an undrawn scalar, for the first segment meets it.
void beginLookups(INOUT(CellInterval) cell)
{
#if TETMARCH_KEEPS_TABLE_POINT
  cell.at = tablePoint(isDrawn(cell.leave.y) ? cell.leave.y * tableScale + tableOffset : tableOffset);
#endif
}

// To the tetrahedron that has been stepped through; the face is the one by which the ray leaves it.
void advanceCell(uint tet, FaceIntersection face, INOUT(CellInterval) cell)
{
#if TETMARCH_ISOSURFACES
  cell.before = cell.drawn ? vec2(gatheredEnd(cell), cell.scalar) : cell.before;
#endif
  cell.tet = tet;
  cell.enter = cell.leave;
  cell.leave = intersectionPoint(face);
#if TETMARCH_VERTEX_ATTRIBUTES
  cell.enterAttributes = cell.leaveAttributes;
  cell.leaveAttributes = attributesAt(face);
#endif
  cell.scalar = cellScalar(tet, cell.leave);
}

// Decides whether anything is seen between cell.begin and cell.end, which is nothing unless the ray goes forward.
void decideVisibility(bool forward, INOUT(CellInterval) cell)
{
#if TETMARCH_POINT_SCALARS
  real first = cell.enter.y;
#else
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
}
