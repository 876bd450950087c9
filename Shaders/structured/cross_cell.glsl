// The step from cell to cell of a lattice, or from leaf to leaf of an octree. A trilinear cell is crossed in up to three
// parts, and the scalar is monotonic in each part. With several components there are up to nine parts; each scalar with
// a table is monotonic in each part.

CellInterval beginCellInterval(Ray ray, INOUT(RayPosition) place)
{
  CellInterval cell;
  beginCell(cell);
#if TETMARCH_CELL_PARTS
  // A march that has paused may continue within a cell.
  real begin = isWithinCell(place) ? place.depth + (place.leave - place.depth) * place.position : place.leave;
#else
  real begin = place.leave;
#endif
  cell.leave = vec2(begin, UNDRAWN_SCALAR);
  cell.number = numberOfCell(place.cell);
  beginLookups(cell);
#if TETMARCH_POINT_SAMPLED || TETMARCH_LIT_COMPONENTS
  cell.ray = ray;
#endif
  return cell;
}

#if !TETMARCH_LEAF_CELLS
// The cell behind the first plane that the ray crosses; for equal depths, the first axis.
ivec3 nextCell(Ray ray, ivec3 cell, vec3 crossings)
{
  bool acrossX = crossings.x <= crossings.y && crossings.x <= crossings.z;
  bool acrossY = !acrossX && crossings.y <= crossings.z;
  bool acrossZ = !acrossX && !acrossY;
  return ivec3(cell.x + (acrossX ? ray.steps.x : 0), cell.y + (acrossY ? ray.steps.y : 0),
    cell.z + (acrossZ ? ray.steps.z : 0));
}
#endif

#if TETMARCH_LEAPS || TETMARCH_LEAF_CELLS
// The cell behind the first of any planes that the ray crosses. beside: the indices along the other axes.
ivec3 cellBehind(Ray ray, ivec3 plane, vec3 crossings, ivec3 beside)
{
  bool acrossX = crossings.x <= crossings.y && crossings.x <= crossings.z;
  bool acrossY = !acrossX && crossings.y <= crossings.z;
  bool acrossZ = !acrossX && !acrossY;
  return ivec3(acrossX ? (ray.steps.x > 0 ? plane.x : plane.x - 1) : beside.x,
    acrossY ? (ray.steps.y > 0 ? plane.y : plane.y - 1) : beside.y,
    acrossZ ? (ray.steps.z > 0 ? plane.z : plane.z - 1) : beside.z);
}

// The landing cell of a ray that leaves a cube of cells, along the other axes: between the cell where it was and the
// cube's plane. If rounding yields a neighbour of the right cell, the ray leaves it before anything is gathered.
int landingAlong(int cell, int from, int plane, int direction)
{
  return direction > 0 ? clamp(cell, from, plane - 1) : clamp(cell, plane, from);
}

ivec3 landingOf(Ray ray, real depth, ivec3 from, ivec3 plane)
{
  ivec3 cell = cellAround(ray.start + ray.slope * depth);
  return ivec3(landingAlong(cell.x, from.x, plane.x, ray.steps.x), landingAlong(cell.y, from.y, plane.y, ray.steps.y),
    landingAlong(cell.z, from.z, plane.z, ray.steps.z));
}
#endif

#if TETMARCH_LEAPS
ivec3 blockOf(ivec3 cell) { return ivec3(cell.x >> LEAP_SHIFT, cell.y >> LEAP_SHIFT, cell.z >> LEAP_SHIFT); }

// The number of blocks by which the transparent cube extends beyond the given one; 0: there is no such cube.
int leapOf(ivec3 block) { return fetchBlockDistance(block.x + blockCount.x * (block.y + blockCount.y * block.z)); }

// The plane perpendicular to an axis through which a ray leaves the cube around a block.
int cubeEnd(int block, int direction, int reach, int cells)
{
  return direction > 0 ? min((block + reach) << LEAP_SHIFT, cells) : max((block - reach + 1) << LEAP_SHIFT, 0);
}

// Before a cell in a transparent cube, the ray leaps out of the cube, unless it is within that cell. Returns whether it
// is then still in the lattice. The landing cell is crossed in the same iteration of the march's loop: leaping,
// crossing or both take one loop iteration.
bool leap(Ray ray, INOUT(RayPosition) place, INOUT(CellInterval) cell)
{
  ivec3 block = blockOf(place.cell);
  int reach = leapOf(block);
  bool leaps = reach > 0 && !isWithinCell(place);
  ivec3 far = ivec3(cubeEnd(block.x, ray.steps.x, reach, latticeCells.x),
    cubeEnd(block.y, ray.steps.y, reach, latticeCells.y), cubeEnd(block.z, ray.steps.z, reach, latticeCells.z));
  vec3 crossings = crossingDepths(ray, far, NO_DEPTH);
  real depth = leastOf(crossings);
  bool inside = depth < place.end;
  ivec3 landing = cellBehind(ray, far, crossings, landingOf(ray, depth, place.cell, far));
  place.cell = leaps && inside ? landing : place.cell;
  place.leave = leaps ? depth : place.leave;
  cell.leave = leaps ? vec2(depth, UNDRAWN_SCALAR) : cell.leave;
  cell.seen = cell.seen && !leaps;
  return inside || !leaps;
}
#endif

#if TETMARCH_CELL_PARTS
// The part of the cell up to the next extreme of the scalar.
void takePart(INOUT(RayPosition) place, INOUT(CellInterval) cell)
{
  real from = place.position;
  real next = place.extremes.x > from ? place.extremes.x : place.extremes.y;
  real to = next > from ? min(next, real(1)) : real(1);
#if TETMARCH_BENT_COMPONENTS && !TETMARCH_DIRECT_COLOR
  to = min(to, nextExtraExtreme(place.extra, from));
#endif
  real length = place.leave - place.depth;
  bool hasScalar = isDrawn(place.cubic.x);
  // The scalar at the end of the last interval is the same up to rounding; so the table need not be read there again.
  real begin = isDrawn(cell.leave.y) ? cell.leave.y : cubicAt(place.cubic, from);
  cell.enter = vec2(cell.leave.x, hasScalar ? begin : UNDRAWN_SCALAR);
  cell.leave = vec2(
    to < real(1) ? place.depth + length * to : place.leave, hasScalar ? cubicAt(place.cubic, to) : UNDRAWN_SCALAR);
  cell.bend = bendWithin(vec2(place.cubic.z, place.cubic.w), from, to);
#if TETMARCH_BENT_COMPONENTS
  cell.extraEnter = extraCubicsAt(place.extra, from);
  cell.extraLeave = extraCubicsAt(place.extra, to);
  cell.extraBend = extraBendWithin(place.extra.bend, from, to);
#endif
  cell.scalar = cell.leave.y;
  place.position = to;
}
#elif TETMARCH_POINT_SCALARS
// The whole cell.
void takeCell(RayPosition place, vec4 cubic, INOUT(CellInterval) cell)
{
  bool hasScalar = isDrawn(cubic.x);
  cell.enter = vec2(place.depth, cubic.x);
  cell.leave = vec2(place.leave, hasScalar ? cubicAt(cubic, real(1)) : UNDRAWN_SCALAR);
  cell.bend = vec2(cubic.z, cubic.w);
  cell.scalar = cell.leave.y;
}
#endif

#if !TETMARCH_POINT_SCALARS
// The whole cell, with the value of these indices.
void takeConstantCell(RayPosition place, ivec3 value, INOUT(CellInterval) cell)
{
  cell.scalar = fetchValue(value.x, value.y, value.z);
#if TETMARCH_COMPONENTS
  cell.extra = fetchExtraValues(value.x, value.y, value.z);
#endif
  cell.enter = vec2(place.depth, cell.scalar);
  cell.leave = vec2(place.leave, cell.scalar);
}
#endif

#if TETMARCH_LEAF_CELLS
// The ray enters the leaf ahead.
void enterLeaf(Leaf leaf, real leave, INOUT(RayPosition) place, INOUT(CellInterval) cell)
{
  place.depth = place.leave;
  place.leave = leave;
  cell.number = leaf.number;
  takeConstantCell(place, valueOfLeaf(leaf), cell);
}
#else
// The ray enters the cell ahead.
void enterCell(Ray ray, real leave, INOUT(RayPosition) place, INOUT(CellInterval) cell)
{
  place.depth = place.leave;
  place.leave = leave;
  cell.number = numberOfCell(place.cell);
#if TETMARCH_CELL_PARTS
  place.position = real(0);
  place.cubic = cubicAlong(ray, place.cell, place.depth, place.leave);
  place.extremes = extremesOf(place.cubic);
#if TETMARCH_BENT_COMPONENTS
  place.extra = extraCubicsAlong(ray, place.cell, place.depth, place.leave);
#endif
#elif TETMARCH_POINT_SCALARS
  takeCell(place, cubicAlong(ray, place.cell, place.depth, place.leave), cell);
#else
  ivec3 value = ivec3(place.cell.x + firstValue.x, place.cell.y + firstValue.y, place.cell.z + firstValue.z);
  takeConstantCell(place, value, cell);
#endif
}
#endif

Crossing crossCell(Ray ray, INOUT(RayPosition) place, INOUT(CellInterval) cell)
{
  Crossing crossing;
  crossing.lost = false;
  keepLastDrawn(cell);
#if TETMARCH_LEAPS
  bool inside = leap(ray, place, cell);
#else
  bool inside = true;
#endif
#if TETMARCH_EFFECTS || TETMARCH_LIT_COMPONENTS
  place.crossed = place.cell;
#endif
#if TETMARCH_LEAF_CELLS
  Leaf leaf = leafAround(place.cell);
  ivec3 ahead = planesAheadOf(ray, leaf);
  vec3 crossings = crossingDepths(ray, ahead, NO_DEPTH);
#else
  vec3 crossings = crossingDepths(ray, planesAhead(ray, place.cell), NO_DEPTH);
#endif
  crossing.cells = isWithinCell(place) ? 0 : 1;
#if TETMARCH_LEAF_CELLS
  enterLeaf(leaf, inside ? min(leastOf(crossings), place.end) : place.leave, place, cell);
#elif TETMARCH_CELL_PARTS
  if (!isWithinCell(place))
  {
    enterCell(ray, inside ? min(leastOf(crossings), place.end) : place.leave, place, cell);
  }
  takePart(place, cell);
#else
  enterCell(ray, inside ? min(leastOf(crossings), place.end) : place.leave, place, cell);
#endif
  bool crossed = !isWithinCell(place);
  // The depth of the lattice's last plane is the same to the bit for each cell before it.
  crossing.onward = !crossed || place.leave < place.end;
#if TETMARCH_LEAF_CELLS
  ivec3 next = cellBehind(ray, ahead, crossings, landingOf(ray, place.leave, place.cell, ahead));
#else
  ivec3 next = nextCell(ray, place.cell, crossings);
#endif
  place.cell = crossing.onward && crossed ? next : place.cell;
  return crossing;
}
