// The interval of a ray in a cell, and the data at its ends. If the scalar bends in a cell, the cell has several
// consecutive intervals, and the scalar is monotonic in each.

struct CellInterval
{
  uint number; // of the cell
  vec2 enter;  // depth and scalar where the interval begins
  vec2 leave;  // and where it ends
  real begin;  // begin and end of the integrated part
  real end;
  real scalar; // of the cell, or where the ray leaves it
  bool seen;   // the cell contributes to the pixel
#if TETMARCH_CURVED_ERROR
  real enterShift; // by which the faces where the ray enters and leaves may be elsewhere
  real leaveShift;
#endif
#if TETMARCH_BENT
  vec2 bend;   // of the scalar from enter to leave; see structured/bend.glsl
#endif
#if TETMARCH_BENT_COMPONENTS
  vec3 extraEnter; // extra scalars where the interval begins
  vec3 extraLeave;
  ExtraBend extraBend;
#elif TETMARCH_COMPONENTS && TETMARCH_STRUCTURED
  vec3 extra; // extra scalars of the cell
#endif
#if TETMARCH_KEEPS_TABLE_POINT
  TablePoint at; // the table at the end of the last lookup
#endif
#if TETMARCH_CELL_ATTRIBUTES
  VertexAttributes enterAttributes; // interpolated
  VertexAttributes leaveAttributes;
#endif
#if TETMARCH_EVEN_GRADIENT
  vec3 gradient; // in the normalised frame
#endif
#if TETMARCH_EFFECTS
  // Not in a struct of their own: WebGL allows structs in structs up to a depth of 4.
  Shade enterShade;  // at the ray's entry into the cell
  Shade leaveShade;
  vec2 shadesWithin; // begin and end of the current segment between them: 0 and 1 if that is the whole cell
#if TETMARCH_FINDS_SHADES
  bool enterShadeKnown; // it is that at the ray's exit from the previous cell
#endif
#if TETMARCH_VERTEX_LIGHT_ERROR
  real interpolationError; // of light interpolated between vertices
#endif
#endif
#if TETMARCH_CROPPED
  real rest;   // depth up to which further ranges of the cell may remain after cropping
#endif
#if TETMARCH_NAN_SHOWN
  bool finite; // the scalar is finite
#endif
#if TETMARCH_POINT_SAMPLED || TETMARCH_LIT_COMPONENTS
  Ray ray;     // the ray that crosses the cell
#endif
#if TETMARCH_KEEPS_CROSSED
  ivec3 crossed; // the cell's indices along the axes
#endif
#if TETMARCH_PAUSES_WITHIN
  RayPosition before; // the ray's position before it crosses the cell
#endif
#if TETMARCH_ISOSURFACES
  bool drawn;  // the cell has a scalar and is not hidden, even if no surface crosses it
  vec2 before; // depth and scalar where the ray left the last drawn cell
#endif
};

#if TETMARCH_POINT_SCALARS && !TETMARCH_WHOLE_INTERVALS
// The scalar at a depth in the interval.
real scalarIn(CellInterval cell, real depth)
{
#if TETMARCH_BENT
  return bentScalar(cell.enter.y, cell.leave.y, cell.bend, fractionAt(cell.enter, cell.leave, depth));
#else
  return scalarAt(cell.enter, cell.leave, depth);
#endif
}
#endif

#if TETMARCH_EXTRA_VERTEX_SCALARS
vec3 extraAt(CellInterval cell, real depth)
{
  return cell.enterAttributes.extra +
    (cell.leaveAttributes.extra - cell.enterAttributes.extra) * fractionAt(cell.enter, cell.leave, depth);
}
#endif

#if TETMARCH_BENT_COMPONENTS && !TETMARCH_WHOLE_INTERVALS
vec3 extraAt(CellInterval cell, real depth)
{
  return bentScalars(
    cell.extraEnter, cell.extraLeave, cell.extraBend, fractionAt(cell.enter, cell.leave, depth));
}
#endif

// The segment between cell.begin and cell.end.
Segment visibleSegment(CellInterval cell)
{
  Segment segment;
#if TETMARCH_WHOLE_INTERVALS
  segment.begin = cell.enter;
  segment.end = cell.leave;
  segment.bend = cell.bend;
#elif TETMARCH_POINT_SCALARS
  segment.begin = vec2(
    cell.begin, cell.begin > cell.enter.x ? scalarIn(cell, cell.begin) : cell.enter.y);
  segment.end =
    vec2(cell.end, cell.end < cell.leave.x ? scalarIn(cell, cell.end) : cell.leave.y);
#if TETMARCH_BENT
  segment.bend = bendWithin(cell.bend, fractionAt(cell.enter, cell.leave, cell.begin),
    fractionAt(cell.enter, cell.leave, cell.end));
#endif
#else
  segment.begin = vec2(cell.begin, cell.scalar);
  segment.end = vec2(cell.end, cell.scalar);
#endif
#if TETMARCH_EXTRA_VERTEX_SCALARS
  segment.extraBegin = cell.begin > cell.enter.x ? extraAt(cell, cell.begin) : cell.enterAttributes.extra;
  segment.extraEnd = cell.end < cell.leave.x ? extraAt(cell, cell.end) : cell.leaveAttributes.extra;
#elif TETMARCH_BENT_COMPONENTS && TETMARCH_WHOLE_INTERVALS
  segment.extraBegin = cell.extraEnter;
  segment.extraEnd = cell.extraLeave;
  segment.extraBend = cell.extraBend;
#elif TETMARCH_BENT_COMPONENTS
  segment.extraBegin = cell.begin > cell.enter.x ? extraAt(cell, cell.begin) : cell.extraEnter;
  segment.extraEnd = cell.end < cell.leave.x ? extraAt(cell, cell.end) : cell.extraLeave;
  segment.extraBend = extraBendWithin(cell.extraBend, fractionAt(cell.enter, cell.leave, cell.begin),
    fractionAt(cell.enter, cell.leave, cell.end));
#elif TETMARCH_COMPONENTS && TETMARCH_STRUCTURED
  segment.extraBegin = cell.extra;
#elif TETMARCH_COMPONENTS
  segment.extraBegin = fetchExtraScalars(cell.number);
#endif
#if TETMARCH_ISOSURFACES
  // Cell scalars change between two cells. If cells overlap by rounding, no value is crossed twice.
  segment.begin = vec2(cell.begin, cell.begin <= cell.before.x ? cell.before.y : segment.begin.y);
#endif
  return segment;
}

#if TETMARCH_EFFECTS
// Begin and end of a segment in the interval: 0 and 1 if it is the whole interval.
vec2 rangeWithin(CellInterval cell, Segment segment)
{
#if TETMARCH_WHOLE_INTERVALS
  return vec2(real(0), real(1));
#else
  return vec2(segment.begin.x > cell.enter.x ? fractionAt(cell.enter, cell.leave, segment.begin.x) : real(0),
    segment.end.x < cell.leave.x ? fractionAt(cell.enter, cell.leave, segment.end.x) : real(1));
#endif
}
#endif

#if TETMARCH_ISOSURFACES
// Depth up to which the cell has been integrated.
real gatheredEnd(CellInterval cell)
{
#if TETMARCH_CROPPED
  return cell.rest;
#else
  return cell.end;
#endif
}
#endif

// Before the volume: nothing has been crossed.
void beginCell(OUT(CellInterval) cell)
{
  cell.seen = false;
#if TETMARCH_ISOSURFACES
  cell.drawn = false;
  cell.before = vec2(-NO_DEPTH, real(0));
#endif
}

// There the last lookup is that at the begin of the table; not of an undrawn scalar, which the first segment may have.
void beginLookups(INOUT(CellInterval) cell)
{
#if TETMARCH_KEEPS_TABLE_POINT
  cell.at = tablePoint(isDrawn(cell.leave.y) ? cell.leave.y * tableScale + tableOffset : tableOffset);
#endif
}

// Before cell becomes the next one.
void keepLastDrawn(INOUT(CellInterval) cell)
{
#if TETMARCH_ISOSURFACES
  cell.before = cell.drawn ? vec2(gatheredEnd(cell), cell.scalar) : cell.before;
#endif
}

// Sets whether the cell is visible between cell.begin and cell.end; never if the ray does not go forward.
void decideVisibility(bool forward, INOUT(CellInterval) cell)
{
#if TETMARCH_POINT_SCALARS
  real first = cell.enter.y;
#else
  real first = cell.scalar;
#endif
  bool open = forward;
#if TETMARCH_HIDDEN_CELLS
  open = open && !isHidden(cell.number);
#endif
  cell.seen = open && isDrawn(first) && isDrawn(cell.scalar);
#if TETMARCH_TRANSPARENT_RANGES && TETMARCH_EVEN_CUTS
  real reach = greatestBend(cell.bend);
  cell.seen = cell.seen &&
    !isTransparentBetween((min(first, cell.scalar) - reach) * tableScale + tableOffset,
      (max(first, cell.scalar) + reach) * tableScale + tableOffset);
#elif TETMARCH_TRANSPARENT_RANGES
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
