// Cropping: two planes perpendicular to each axis divide the volume into 27 regions. The mapper's cropping flags say
// which are drawn. A ray crosses at most six of the planes, and is integrated from plane to plane.

#if TETMARCH_CROPPED
// Six planes separate 7 ranges of a ray. The bound of loops is not constant, so that they are not unrolled.
int mostRanges() { return max(7, mostSteps); }

// The depth behind the given one at which the ray crosses the next plane.
real nextPlane(Ray ray, real depth)
{
  vec3 low = ray.lowDepth;
  vec3 high = ray.highDepth;
  real x = min(low.x > depth ? low.x : NO_DEPTH, high.x > depth ? high.x : NO_DEPTH);
  real y = min(low.y > depth ? low.y : NO_DEPTH, high.y > depth ? high.y : NO_DEPTH);
  real z = min(low.z > depth ? low.z : NO_DEPTH, high.z > depth ? high.z : NO_DEPTH);
  return min(x, min(y, z));
}

// The number of two planes perpendicular to an axis that are below a point or contain it.
int planesBelow(real place, real low, real high) { return (place >= low ? 1 : 0) + (place >= high ? 1 : 0); }

bool isInRegionLeft(vec3 point)
{
  int region = planesBelow(point.x, croppingLow.x, croppingHigh.x) +
    3 * planesBelow(point.y, croppingLow.y, croppingHigh.y) +
    9 * planesBelow(point.z, croppingLow.z, croppingHigh.z);
  return ((croppingFlags >> region) & 1) != 0;
}

// The first remaining range of depths, from plane to plane, of the ray between two depths; if none remains, one that
// does not end behind its begin. The middle of a range determines the region: its distance from the planes exceeds
// rounding.
vec2 nextRange(Ray ray, real depthBegin, real depthEnd)
{
  vec2 range = vec2(depthBegin, depthBegin);
  bool searching = depthBegin < depthEnd;
  int ranges = 0;
  while (searching && ranges < mostRanges())
  {
    ranges = ranges + 1;
    real begin = range.y;
    real end = min(nextPlane(ray, begin), depthEnd);
    bool left = isInRegionLeft(ray.origin + ray.direction * (real(0.5) * (begin + end)));
    range = vec2(left ? begin : end, end);
    searching = !left && end < depthEnd;
  }
  return range;
}

// Moves to the next remaining range of the cell. Returns whether there is one.
bool nextRangeOfCell(Ray ray, INOUT(CellInterval) cell)
{
  vec2 range = nextRange(ray, cell.end, cell.rest);
  bool found = range.y > range.x;
  cell.begin = found ? range.x : cell.begin;
  cell.end = found ? range.y : cell.end;
  return found;
}
#endif

// Restricts the cell's interval to its first remaining range.
void cropCell(Ray ray, INOUT(CellInterval) cell)
{
#if TETMARCH_CROPPED
  cell.rest = cell.end;
  vec2 range = nextRange(ray, cell.begin, cell.seen ? cell.end : cell.begin);
  cell.begin = range.x;
  cell.end = range.y;
  cell.seen = cell.seen && range.y > range.x;
#endif
}
