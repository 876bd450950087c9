// Opacity times intensity, integrated along the ray (blend mode additive), or averaged over the part of it whose scalar
// is in a range (blend mode average). The tables have the intensity, a scalar's position in the range of the data, as
// their colour, and the opacity as extinction: so their means of C tau are exactly the means of the product.

// What a ray has gathered.
struct Radiance
{
  real sum;           // integral over depths
  real countedLength; // of the part whose scalar is in the range
};

Radiance noRadiance()
{
  Radiance radiance;
  radiance.sum = real(0);
  radiance.countedLength = real(0);
  return radiance;
}

#if TETMARCH_PICKED
real gathered(Radiance radiance) { return radiance.sum; }
#endif

// Any cell behind adds to the sum.
bool isOpaque(Radiance radiance) { return false; }

real errorBound(Radiance radiance) { return real(0); }

// An opaque gray where anything counts.
vec4 pixelOf(Radiance radiance, real thicknessPerDepth)
{
  bool counts = radiance.countedLength > real(0);
  real factor = averages ? real(1) / max(radiance.countedLength, TINY) : thicknessPerDepth;
  real gray = radiance.sum > real(0) ? min(radiance.sum * factor, real(1)) : real(0);
  return vec4(gray, gray, gray, counts ? real(1) : real(0));
}

// The fraction of a segment whose scalar is in the range; from, to: the scalars at its ends, clamped to the range.
real countedFraction(Segment segment, real from, real to)
{
  real rise = segment.end.y - segment.begin.y;
  real whole = from == segment.begin.y ? real(1) : real(0);
  return rise == real(0) ? whole : (to - from) / rise;
}

int gatherSegment(Segment segment, real thicknessPerDepth, INOUT(CellInterval) cell, INOUT(Radiance) radiance)
{
  real from = clamp(segment.begin.y, averageRange.x, averageRange.y);
  real to = clamp(segment.end.y, averageRange.x, averageRange.y);
  real counted = (segment.end.x - segment.begin.x) * countedFraction(segment, from, to);
#if TETMARCH_POINT_SCALARS
  real mean =
    meanBetween(tablePoint(from * tableScale + tableOffset), tablePoint(to * tableScale + tableOffset)).x;
#else
  vec4 value = tableValue(from * tableScale + tableOffset);
  real mean = value.x * value.w;
#endif
  radiance.sum = radiance.sum + mean * counted;
  radiance.countedLength = radiance.countedLength + counted;
  return 1;
}
