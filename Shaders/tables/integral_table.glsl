// Colour C and extinction tau as functions of the scalar, linear between the n entries of a table, and their integrals
// T(x) = integral of tau, K(x) = integral of C tau. V(x) is the total variation of C up to x, of the channel with the
// largest change in each bin; likewise for the slopes.
//
// x is in units of entries. The first and the last bin are constant, so that the formulas hold for any x beyond the
// table. Integrals up to an entry are 32-bit fixed-point numbers: their differences are exact. The integral at x is the
// one up to the entry next to x plus the area from there to x, whose part outside of an interval is at most a small
// multiple of that inside. So a mean loses no digits, and spikes between the ends are never missed.

// Positions are clamped to it before they become integers. A constant, since a GPU keeps the size as a float in a
// register of each ray.
CONSTANT real MOST_POSITION = real(1e9);

#if TETMARCH_COMPONENTS
// The position of one table among the consecutive tables of several components; x is in units of its own entries.
struct TableSpan
{
  int first;
  int size;
  vec4 integralUnit;
  real scale; // factor from a stored scalar to a position in it
  real offset;
};

TableSpan tableSpan(int table)
{
  TableSpan span;
  span.first = fetchTableFirst(table);
  span.size = fetchTableSize(table);
  span.integralUnit = fetchTableIntegralUnit(table);
  vec2 place = fetchTablePlace(table);
  span.scale = place.x;
  span.offset = place.y;
  return span;
}

int tableBin(TableSpan table, real x)
{
  return clamp(int(max(real(0), min(x, MOST_POSITION))), 0, table.size - 2);
}
#else
// A valid bin of the table even if x is NaN.
int tableBin(real x) { return clamp(int(max(real(0), min(x, MOST_POSITION))), 0, tableSize - 2); }
#endif

#if TETMARCH_TRANSPARENT_RANGES
// Whether there is no extinction from position p to q: below the first, above the last, or in the widest gap.
bool isTransparentBetween(real p, real q)
{
  real low = smallerOf(p, q);
  real high = largerOf(p, q);
  return high <= transparentRanges.x || low >= transparentRanges.y ||
    (low >= transparentRanges.z && high <= transparentRanges.w);
}
#endif

#if TETMARCH_COMPONENTS
vec4 tableValue(TableSpan table, real x)
{
  int bin = tableBin(table, x);
  vec4 begin = fetchTableValue(table.first + bin);
  vec4 end = fetchTableValue(table.first + bin + 1);
#else
vec4 tableValue(real x)
{
  int bin = tableBin(x);
  vec4 begin = fetchTableValue(bin);
  vec4 end = fetchTableValue(bin + 1);
#endif
  // Beyond the table both are equal; the clamp keeps infinite weights away.
  return begin + (end - begin) * clamp(x - real(bin), real(0), real(1));
}

// Means of C tau and tau for C and tau linear from p to q (Engel, Kraus and Ertl 2001): the weights of C at p and q.
vec2 meanWeights(real p, real q)
{
  real sixth = real(1) / real(6);
  return vec2((real(2) * p + q) * sixth, (p + real(2) * q) * sixth);
}

vec4 linearMean(vec4 p, vec4 q)
{
  vec2 weights = meanWeights(p.w, q.w);
  return vec4(p.x * weights.x + q.x * weights.y, p.y * weights.x + q.y * weights.y,
    p.z * weights.x + q.z * weights.y, real(0.5) * (p.w + q.w));
}

// The entry of a bin, 0 or 1, next to a distance from its begin.
int entryNextTo(real distance) { return distance > real(0.5) ? 1 : 0; }

// The table at a position in a bin.
struct BinPoint
{
  vec4 value; // C, tau
  vec4 area;  // from the entry next to it to the position, negative if the position is before that entry
  real rise;  // the maximum change of a channel of C in the bin
};

// distance: of the position from the bin's begin. Channel by channel: a GPU has few registers.
BinPoint binPoint(vec4 begin, vec4 end, real distance)
{
  BinPoint p;
  // Beyond the table both ends are equal.
  real fraction = clamp(distance, real(0), real(1));
  bool nextToEnd = distance > real(0.5);
  real along = nextToEnd ? distance - real(1) : distance;
  p.value.w = begin.w + (end.w - begin.w) * fraction;
  real near = nextToEnd ? end.w : begin.w;
  vec2 weights = meanWeights(near, p.value.w);
  p.area.w = real(0.5) * (near + p.value.w) * along;
  p.rise = abs(end.x - begin.x);
  p.value.x = begin.x + (end.x - begin.x) * fraction;
  p.area.x = ((nextToEnd ? end.x : begin.x) * weights.x + p.value.x * weights.y) * along;
  p.rise = largerOf(p.rise, abs(end.y - begin.y));
  p.value.y = begin.y + (end.y - begin.y) * fraction;
  p.area.y = ((nextToEnd ? end.y : begin.y) * weights.x + p.value.y * weights.y) * along;
  p.rise = largerOf(p.rise, abs(end.z - begin.z));
  p.value.z = begin.z + (end.z - begin.z) * fraction;
  p.area.z = ((nextToEnd ? end.z : begin.z) * weights.x + p.value.z * weights.y) * along;
  return p;
}

// An interval between two positions.
struct IntervalMean
{
  vec4 mean; // of C tau and tau
#if TETMARCH_ERROR_BOUND
  real variation; // of C between the ends
#endif
#if TETMARCH_EXTINCTION_VARIATION
  real extinctionVariation; // of tau
#endif
#if TETMARCH_ERROR_BOUND && TETMARCH_INDEPENDENT
  vec4 ends; // sum of C and of tau at both
#endif
#if TETMARCH_TABLE_ERROR && !TETMARCH_INDEPENDENT
  real perBins; // 1 / the number of bins, or 0 if the mean is computed from values only
#endif
};

#if TETMARCH_DEPENDENT
// Of the first table, that of the opacity.
vec4 tableValue(real x) { return tableValue(tableSpan(0), x); }
#endif
