// Opacity times intensity, integrated along the ray (blend mode additive), or averaged over the part of it whose scalar
// is in a range (blend mode average). The tables have the intensity, a scalar's place in the range of the data, as their
// colour, and the opacity as extinction: so their means of C tau are what is asked for, exactly.

// What a ray has gathered.
struct Radiance
{
  real sum;    // integral over depths
  real length; // of what counts
};

Radiance noRadiance()
{
  Radiance radiance;
  radiance.sum = real(0);
  radiance.length = real(0);
  return radiance;
}

#if TETMARCH_PICKED
real gathered(Radiance radiance) { return radiance.sum; }
#endif

// What lies behind always counts.
bool isOpaque(Radiance radiance) { return false; }

real errorBound(Radiance radiance) { return real(0); }

// An opaque gray where anything counts.
vec4 pixelOf(Radiance radiance, real thicknessPerDepth)
{
  bool counts = radiance.length > real(0);
  real factor = averages ? real(1) / max(radiance.length, TINY) : thicknessPerDepth;
  real gray = radiance.sum > real(0) ? min(radiance.sum * factor, real(1)) : real(0);
  return vec4(gray, gray, gray, counts ? real(1) : real(0));
}

int gatherSegment(Segment piece, real thicknessPerDepth, INOUT(CellInterval) cell, INOUT(Radiance) radiance)
{
  real extent = piece.end.x - piece.begin.x;
  // Clamped to the range, scalars keep the share of the piece that lies in it.
  real from = clamp(piece.begin.y, averageRange.x, averageRange.y);
  real to = clamp(piece.end.y, averageRange.x, averageRange.y);
  real rise = piece.end.y - piece.begin.y;
  real whole = from == piece.begin.y ? real(1) : real(0);
  real counted = extent * (rise == real(0) ? whole : (to - from) / rise);
#if TETMARCH_POINT_SCALARS
  real mean =
    meanBetween(tablePoint(from * tableScale + tableOffset), tablePoint(to * tableScale + tableOffset)).x;
#else
  vec4 value = tableValue(from * tableScale + tableOffset);
  real mean = value.x * value.w;
#endif
  radiance.sum = radiance.sum + mean * counted;
  radiance.length = radiance.length + counted;
  return 1;
}
