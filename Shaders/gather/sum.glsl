// Opacity times intensity, integrated along the ray (blend mode additive), or averaged over the part of it whose scalar
// is in a range (blend mode average). The colour of the tables is the intensity, a scalar's position in the range of
// the data, and their extinction is the opacity: so their means of C tau are exactly the means of the product.

// A compensated sum of many terms (Neumaier 1974): its error does not grow with their number.
struct LongSum
{
  real rounded;
  real cutOff;
};

LongSum emptySum()
{
  LongSum sum;
  sum.rounded = real(0);
  sum.cutOff = real(0);
  return sum;
}

void addTo(INOUT(LongSum) sum, real term)
{
  // Knuth's sum of two numbers, whichever is greater, and its rounding error, which is exact.
  precise real rounded = sum.rounded + term;
  precise real added = rounded - sum.rounded;
  precise real cutOff = (sum.rounded - (rounded - added)) + (term - added);
  sum.rounded = rounded;
  sum.cutOff = sum.cutOff + cutOff;
}

real valueOf(LongSum sum) { return sum.rounded + sum.cutOff; }

// The state of a ray.
struct Radiance
{
  LongSum sum;           // integral over depths
  LongSum countedLength; // of the part whose scalar is in the range
#if TETMARCH_DIAGNOSTICS
  real error;            // of the sum
#endif
};

Radiance noRadiance()
{
  Radiance radiance;
  radiance.sum = emptySum();
  radiance.countedLength = emptySum();
#if TETMARCH_DIAGNOSTICS
  radiance.error = real(0);
#endif
  return radiance;
}

#if TETMARCH_PICKED
real gathered(Radiance radiance) { return valueOf(radiance.sum); }
#endif

// Any cell behind adds to the sum.
bool isOpaque(Radiance radiance) { return false; }

// The factor of the sum: the reciprocal of the length that counts for an average, or the thickness.
real factorOf(Radiance radiance, real thicknessPerDepth)
{
  return averages ? real(1) / max(valueOf(radiance.countedLength), TINY) : thicknessPerDepth;
}

// Error bound of the gray by the integrals' steps (tables/integral_table.glsl) and the rounding of terms.
real errorBound(Radiance radiance)
{
#if TETMARCH_DIAGNOSTICS
  return min(radiance.error * (averages ? factorOf(radiance, real(1)) : real(1)), real(1));
#else
  return real(0);
#endif
}

// An opaque gray if any part counts.
vec4 pixelOf(Radiance radiance, real thicknessPerDepth)
{
  bool counts = radiance.countedLength.rounded > real(0);
  real sum = valueOf(radiance.sum);
  real gray = sum > real(0) ? min(sum * factorOf(radiance, thicknessPerDepth), real(1)) : real(0);
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
  real mean = meanOver(from * tableScale + tableOffset, to * tableScale + tableOffset).mean.x;
#else
  vec4 value = tableValue(from * tableScale + tableOffset);
  real mean = value.x * value.w;
#endif
  precise real term = mean * counted;
  addTo(radiance.sum, term);
  addTo(radiance.countedLength, counted);
#if TETMARCH_DIAGNOSTICS
  // A term, and the gray in the end, are rounded 16 times at most: 16 2^-24.
  real rounding = mean * real(9.5367431640625e-7);
#if TETMARCH_POINT_SCALARS
  rounding = rounding + tableIntegralUnit.x; // over a bin or more, the error of a mean is at most one step
#endif
  radiance.error = radiance.error + rounding * counted * (averages ? real(1) : thicknessPerDepth);
#endif
  return 1;
}
