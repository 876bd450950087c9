// Cropping: two planes across each axis divide the volume into 27 regions, some of which are left. A ray crosses at most
// six of the planes, and is integrated from plane to plane.

// Where behind a depth the ray crosses the next plane.
real nextPlane(Ray ray, real depth)
{
  vec3 low = ray.lowDepth;
  vec3 high = ray.highDepth;
  real x = min(low.x > depth ? low.x : NO_DEPTH, high.x > depth ? high.x : NO_DEPTH);
  real y = min(low.y > depth ? low.y : NO_DEPTH, high.y > depth ? high.y : NO_DEPTH);
  real z = min(low.z > depth ? low.z : NO_DEPTH, high.z > depth ? high.z : NO_DEPTH);
  return min(x, min(y, z));
}

// How many of two planes across an axis lie below a point, or in it.
int planesBelow(real place, real low, real high) { return (place >= low ? 1 : 0) + (place >= high ? 1 : 0); }

bool isLeft(vec3 point)
{
  int region = planesBelow(point.x, croppingLow.x, croppingHigh.x) +
    3 * planesBelow(point.y, croppingLow.y, croppingHigh.y) +
    9 * planesBelow(point.z, croppingLow.z, croppingHigh.z);
  return ((croppingFlags >> region) & 1) != 0;
}

// The first piece, from plane to plane, that is left of the ray between two depths; nothing, if it doesn't end behind
// its begin. In its middle it is farther from the planes than rounding moves it.
vec2 nextSegment(Ray ray, real depthBegin, real depthEnd)
{
  vec2 piece = vec2(depthBegin, depthBegin);
  bool searching = depthBegin < depthEnd;
  while (searching)
  {
    real begin = piece.y;
    real end = min(nextPlane(ray, begin), depthEnd);
    bool left = isLeft(ray.origin + ray.direction * (real(0.5) * (begin + end)));
    piece = vec2(left ? begin : end, end);
    searching = !left && end < depthEnd;
  }
  return piece;
}
