// The planes between the cells of a lattice, and their intersections with a ray. The cell of a ray follows from the
// planes that it has crossed, never from a position: so no cell is skipped or crossed twice. Depths of crossings grow
// with the index of a plane also when they are rounded.

#if TETMARCH_RECTILINEAR
vec3 planesAt(ivec3 i)
{
  return vec3(fetchPlane(firstPlane.x + i.x), fetchPlane(firstPlane.y + i.y), fetchPlane(firstPlane.z + i.z));
}

// The number of planes from first to last at or below a position, minus one, by bisection.
int planeBelow(int first, int cells, real place)
{
  int low = 0;
  int high = cells;
  while (high - low > 1)
  {
    int middle = (low + high) / 2;
    bool below = fetchPlane(first + middle) <= place;
    low = below ? middle : low;
    high = below ? high : middle;
  }
  return low;
}

ivec3 cellAround(vec3 place)
{
  return ivec3(planeBelow(firstPlane.x, latticeCells.x, place.x), planeBelow(firstPlane.y, latticeCells.y, place.y),
    planeBelow(firstPlane.z, latticeCells.z, place.z));
}
#else
real planeAt(int i, real shift, real halfLength) { return clamp(real(i) + shift, -halfLength, halfLength); }

vec3 planesAt(ivec3 i)
{
  return vec3(planeAt(i.x, latticeShift.x, latticeHalfLength.x), planeAt(i.y, latticeShift.y, latticeHalfLength.y),
    planeAt(i.z, latticeShift.z, latticeHalfLength.z));
}

ivec3 cellAround(vec3 place)
{
  return ivec3(int(floor(place.x - latticeShift.x)), int(floor(place.y - latticeShift.y)),
    int(floor(place.z - latticeShift.z)));
}
#endif

// The planes behind the given cell in the ray's direction, for each axis, and before it.
ivec3 planesAhead(Ray ray, ivec3 cell)
{
  return ivec3(cell.x + (ray.steps.x > 0 ? 1 : 0), cell.y + (ray.steps.y > 0 ? 1 : 0),
    cell.z + (ray.steps.z > 0 ? 1 : 0));
}

ivec3 planesPassed(Ray ray, ivec3 cell)
{
  return ivec3(cell.x + (ray.steps.x > 0 ? 0 : 1), cell.y + (ray.steps.y > 0 ? 0 : 1),
    cell.z + (ray.steps.z > 0 ? 0 : 1));
}

// Depths at which the ray crosses a plane for each axis; `none` for an axis perpendicular to the ray.
vec3 crossingDepths(Ray ray, ivec3 plane, real none)
{
  return (planesAt(plane) - ray.start) * ray.perSlope + ray.never * none;
}

real leastOf(vec3 v) { return min(v.x, min(v.y, v.z)); }
real greatestOf(vec3 v) { return max(v.x, max(v.y, v.z)); }

// The depths between which the ray is in the lattice (Liang and Barsky 1984); the first one is not less than the second
// if it misses. A ray perpendicular to an axis is in the lattice if it is between its outermost planes, or in one of
// them.
vec2 depthsOfLattice(Ray ray)
{
  vec3 a = crossingDepths(ray, ivec3(0, 0, 0), -NO_DEPTH);
  vec3 b = crossingDepths(ray, latticeCells, NO_DEPTH);
  vec2 range = vec2(greatestOf(vec3(min(a.x, b.x), min(a.y, b.y), min(a.z, b.z))),
    leastOf(vec3(max(a.x, b.x), max(a.y, b.y), max(a.z, b.z))));
  vec3 low = planesAt(ivec3(0, 0, 0));
  vec3 high = planesAt(latticeCells);
  bool beside = (ray.steps.x == 0 && (ray.start.x < low.x || ray.start.x > high.x)) ||
    (ray.steps.y == 0 && (ray.start.y < low.y || ray.start.y > high.y)) ||
    (ray.steps.z == 0 && (ray.start.z < low.z || ray.start.z > high.z));
  return beside ? vec2(NO_DEPTH, -NO_DEPTH) : range;
}

// Moves an index along an axis to the cell whose planes the ray crosses at or before a depth and behind it.
int corrected(int cell, int direction, real passed, real ahead, real depth)
{
  return cell + (passed > depth ? -direction : (ahead <= depth ? direction : 0));
}

// The cell of the ray behind a depth, among those from low to high.
ivec3 cellBehindDepth(Ray ray, real depth, ivec3 low, ivec3 high)
{
  ivec3 cell = cellAround(ray.start + ray.slope * depth);
  cell = ivec3(clamp(cell.x, low.x, high.x), clamp(cell.y, low.y, high.y), clamp(cell.z, low.z, high.z));
  vec3 passed = crossingDepths(ray, planesPassed(ray, cell), -NO_DEPTH);
  vec3 ahead = crossingDepths(ray, planesAhead(ray, cell), NO_DEPTH);
  cell = ivec3(corrected(cell.x, ray.steps.x, passed.x, ahead.x, depth),
    corrected(cell.y, ray.steps.y, passed.y, ahead.y, depth), corrected(cell.z, ray.steps.z, passed.z, ahead.z, depth));
  return ivec3(clamp(cell.x, low.x, high.x), clamp(cell.y, low.y, high.y), clamp(cell.z, low.z, high.z));
}

uint numberOfLatticeCell(ivec3 cell)
{
  return uint(cell.x) + uint(latticeCells.x) * (uint(cell.y) + uint(latticeCells.y) * uint(cell.z));
}

#if !TETMARCH_LEAF_CELLS
uint numberOfCell(ivec3 cell) { return numberOfLatticeCell(cell); }
#endif
