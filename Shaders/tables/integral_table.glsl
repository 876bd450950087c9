// Colour C and extinction tau as functions of the scalar, linear between the n entries of a table, and their integrals
// T(x) = integral of tau, K(x) = integral of C tau. V(x) is the total variation of C up to x, of the channel with the
// largest change in each bin; likewise for the slopes.
//
// x is in units of entries. The first and the last bin are constant, so that the formulas hold for any x beyond the
// table. Integrals up to an entry are 32-bit fixed-point numbers: their differences are exact. The integral at x is the
// one up to the entry next to x plus the area from there to x, whose part outside of an interval is at most a small
// multiple of that inside. So a mean loses no digits, and spikes between the ends are never missed.

// The table at x: one end of an interval.
struct TablePoint
{
  real x;
  int bin;          // the bin that contains x, from entry bin to entry bin + 1
  vec4 value;       // C, tau at x
  vec4 binBegin;    // C, tau at entry bin
  vec4 binEnd;      // C, tau at entry bin + 1
  uvec4 integral;   // K, T at the entry next to x
  vec4 area;        // from that entry to x, negative if x is before it
#if TETMARCH_ERROR_BOUND
  real variation;   // V at x
#endif
#if TETMARCH_EXTINCTION_VARIATION
  real extinctionVariation; // the same of tau
#endif
#if TETMARCH_SLOPE_VARIATION
  vec2 slopeVariation;      // the same of the slopes of tau and of C tau per entry
#endif
};

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
  return clamp(int(max(real(0), min(floor(x), real(table.size - 2)))), 0, table.size - 2);
}
#else
// A valid bin of the table even if x is NaN.
int tableBin(real x) { return clamp(int(max(real(0), min(floor(x), real(tableSize - 2)))), 0, tableSize - 2); }
#endif

#if TETMARCH_TRANSPARENT_RANGES
// Whether there is no extinction from position p to q: below the first, above the last, or in the widest gap.
bool isTransparentBetween(real p, real q)
{
  real low = min(p, q);
  real high = max(p, q);
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

// Means of C tau and tau for C and tau linear from p to q (Engel, Kraus and Ertl 2001).
vec4 linearMean(vec4 p, vec4 q)
{
  real sixth = real(1) / real(6);
  real wp = (real(2) * p.w + q.w) * sixth;
  real wq = (p.w + real(2) * q.w) * sixth;
  return vec4(p.x * wp + q.x * wq, p.y * wp + q.y * wq, p.z * wp + q.z * wq, real(0.5) * (p.w + q.w));
}

// The point x in a bin with the given first entry.
TablePoint pointInBin(real x, int bin, int entry)
{
  TablePoint p;
  p.x = x;
  p.bin = bin;
  p.binBegin = fetchTableValue(entry);
  p.binEnd = fetchTableValue(entry + 1);
  real distance = x - real(bin);
  p.value = p.binBegin + (p.binEnd - p.binBegin) * clamp(distance, real(0), real(1));
  bool nextToEnd = distance > real(0.5);
  p.integral = fetchTableIntegral(nextToEnd ? entry + 1 : entry);
  p.area = linearMean(nextToEnd ? p.binEnd : p.binBegin, p.value) * (nextToEnd ? distance - real(1) : distance);
  return p;
}

#if TETMARCH_ERROR_BOUND || TETMARCH_EXTINCTION_VARIATION
// The fraction of its bin before the point, 0..1.
real fractionOfBin(TablePoint p) { return clamp(p.x - real(p.bin), real(0), real(1)); }
#endif

#if TETMARCH_ERROR_BOUND || TETMARCH_SLOPE_VARIATION
// The maximum change of a channel of C in the point's bin.
real colorRise(TablePoint p)
{
  vec4 rise = p.binEnd - p.binBegin;
  return max(abs(rise.x), max(abs(rise.y), abs(rise.z)));
}
#endif

#if TETMARCH_COMPONENTS
TablePoint tablePoint(TableSpan table, real x)
{
  int bin = tableBin(table, x);
  int entry = table.first + bin;
  TablePoint p = pointInBin(x, bin, entry);
#if TETMARCH_ERROR_BOUND
  vec2 variation = fetchTableVariations(entry);
  p.variation = variation.x + colorRise(p) * fractionOfBin(p);
  p.extinctionVariation = variation.y + abs(p.binEnd.w - p.binBegin.w) * fractionOfBin(p);
#endif
  return p;
}
#else
TablePoint tablePoint(real x)
{
  int bin = tableBin(x);
  TablePoint p = pointInBin(x, bin, bin);
#if TETMARCH_EXTINCTION_VARIATION
  vec2 variation = fetchTableVariations(bin);
#if TETMARCH_ERROR_BOUND
  p.variation = variation.x + colorRise(p) * fractionOfBin(p);
#endif
  p.extinctionVariation = variation.y + abs(p.binEnd.w - p.binBegin.w) * fractionOfBin(p);
#if TETMARCH_SLOPE_VARIATION
  // In a bin tau is linear, and C tau a parabola.
  vec2 slopeVariation = fetchTableSlopeVariations(bin);
  p.slopeVariation = vec2(slopeVariation.x,
    slopeVariation.y + real(2) * abs(p.binEnd.w - p.binBegin.w) * colorRise(p) * fractionOfBin(p));
#endif
#elif TETMARCH_ERROR_BOUND
  p.variation = fetchTableVariation(bin) + colorRise(p) * fractionOfBin(p);
#endif
  return p;
}
#endif

// Means of C tau and tau over the scalars between two points of the table. Entries between them are those of q.
#if TETMARCH_COMPONENTS
vec4 meanBetween(TableSpan table, TablePoint p, TablePoint q)
{
  vec4 integralUnit = table.integralUnit;
#else
vec4 meanBetween(TablePoint p, TablePoint q)
{
  vec4 integralUnit = tableIntegralUnit;
#endif
  bool sameBin = p.bin == q.bin;
  bool ascending = p.bin < q.bin;
  real perRise = real(1) / (sameBin ? real(1) : q.x - p.x);
  // In one bin or in two adjacent ones: linear up to the entry between them, and after it.
  vec4 middle = sameBin ? q.value : (ascending ? q.binBegin : q.binEnd);
  real entry = real(max(p.bin, q.bin));
  real before = sameBin ? real(1) : (entry - p.x) * perRise;
  real behind = sameBin ? real(0) : (q.x - entry) * perRise;
  vec4 straight = linearMean(p.value, middle) * before + linearMean(middle, q.value) * behind;
  // Otherwise the interval is longer than a bin. For tiny integrals their steps are significant.
  vec4 entries = vec4(ascending ? q.integral - p.integral : p.integral - q.integral) * integralUnit;
  vec4 found = entries * abs(perRise) + (q.area - p.area) * perRise;
  vec4 acrossBins =
    vec4(max(found.x, real(0)), max(found.y, real(0)), max(found.z, real(0)), max(found.w, real(0)));
  return abs(p.bin - q.bin) <= 1 ? straight : acrossBins;
}

#if TETMARCH_DEPENDENT
// The first table, that of the opacity.
vec4 tableValue(real x) { return tableValue(tableSpan(0), x); }
TablePoint tablePoint(real x) { return tablePoint(tableSpan(0), x); }
vec4 meanBetween(TablePoint p, TablePoint q) { return meanBetween(tableSpan(0), p, q); }
#endif
