// Colour C and extinction tau as functions of the scalar, linear between the n entries of a table, and their integrals
// T(x) = integral of tau, K(x) = integral of C tau. V(x) is the total variation of C up to x, of the channel that changes
// most in each bin; likewise for the slopes.
//
// x counts entries. The first and the last bin are constant, so that the formulas hold for any x beyond the table as
// well. Integrals up to an entry are 32-bit fixed-point numbers: their differences are exact, so that a mean over a small
// interval loses no digits, and spikes between its ends are never missed.

// The table at x: one end of an interval.
struct TablePoint
{
  real x;
  int bin;          // the bin x lies in, from entry bin to entry bin + 1
  vec4 value;       // C, tau at x
  vec4 binBegin;    // C, tau at entry bin
  vec4 binEnd;      // C, tau at entry bin + 1
#if TETMARCH_ERROR_BOUND
  real variation;   // V at x
#endif
#if TETMARCH_EXTINCTION_VARIATION
  real extinctionVariation; // the same of tau
#endif
#if TETMARCH_SLOPE_VARIATION
  vec2 slopeVariation;      // the same of the slopes of tau and of C tau, an entry
#endif
  uvec4 integral;   // K, T at entry bin
  uvec4 integralEnd; // K, T at entry bin + 1
};

#if TETMARCH_COMPONENTS
// The place of one table among those of several components, which lie behind each other; x counts its own entries.
struct TableSpan
{
  int first;
  int size;
  vec4 integralUnit;
  real scale; // from a stored scalar to a position in it
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

int tableBin(TableSpan table, real x) { return int(max(real(0), min(floor(x), real(table.size - 2)))); }
#else
// The first bin if x is not a number.
int tableBin(real x) { return int(max(real(0), min(floor(x), real(tableSize - 2)))); }
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

#if TETMARCH_COMPONENTS
TablePoint tablePoint(TableSpan table, real x)
{
  TablePoint p;
  p.x = x;
  p.bin = tableBin(table, x);
  int entry = table.first + p.bin;
  p.binBegin = fetchTableValue(entry);
  p.binEnd = fetchTableValue(entry + 1);
#else
TablePoint tablePoint(real x)
{
  TablePoint p;
  p.x = x;
  p.bin = tableBin(x);
  p.binBegin = fetchTableValue(p.bin);
  p.binEnd = fetchTableValue(p.bin + 1);
#endif
  vec4 rise = p.binEnd - p.binBegin;
  real fraction = clamp(x - real(p.bin), real(0), real(1));
  p.value = p.binBegin + rise * fraction;
#if TETMARCH_COMPONENTS
  p.integral = fetchTableIntegral(entry);
  p.integralEnd = fetchTableIntegral(entry + 1);
#if TETMARCH_ERROR_BOUND
  vec2 variation = fetchTableVariations(entry);
  p.variation = variation.x + max(abs(rise.x), max(abs(rise.y), abs(rise.z))) * fraction;
  p.extinctionVariation = variation.y + abs(rise.w) * fraction;
#endif
#else
  p.integral = fetchTableIntegral(p.bin);
  p.integralEnd = fetchTableIntegral(p.bin + 1);
#if TETMARCH_EXTINCTION_VARIATION
  vec2 variation = fetchTableVariations(p.bin);
#if TETMARCH_ERROR_BOUND
  p.variation = variation.x + max(abs(rise.x), max(abs(rise.y), abs(rise.z))) * fraction;
#endif
  p.extinctionVariation = variation.y + abs(rise.w) * fraction;
#if TETMARCH_SLOPE_VARIATION
  // In a bin tau is straight, and C tau a parabola.
  vec2 slopeVariation = fetchTableSlopeVariations(p.bin);
  p.slopeVariation = vec2(slopeVariation.x,
    slopeVariation.y + real(2) * abs(rise.w) * max(abs(rise.x), max(abs(rise.y), abs(rise.z))) * fraction);
#endif
#elif TETMARCH_ERROR_BOUND
  p.variation = fetchTableVariation(p.bin) + max(abs(rise.x), max(abs(rise.y), abs(rise.z))) * fraction;
#endif
#endif
  return p;
}

// Means of C tau and tau where both C and tau run linearly from p to q (Engel, Kraus and Ertl 2001).
vec4 linearMean(vec4 p, vec4 q)
{
  real sixth = real(1) / real(6);
  real wp = (real(2) * p.w + q.w) * sixth;
  real wq = (p.w + real(2) * q.w) * sixth;
  return vec4(p.x * wp + q.x * wq, p.y * wp + q.y * wq, p.z * wp + q.z * wq, real(0.5) * (p.w + q.w));
}

// Means of C tau and tau over the scalars between two points of the table.
#if TETMARCH_COMPONENTS
vec4 meanBetween(TableSpan table, TablePoint p, TablePoint q)
#else
vec4 meanBetween(TablePoint p, TablePoint q)
#endif
{
  bool ascending = p.bin <= q.bin;
  real low = ascending ? p.x : q.x;
  real high = ascending ? q.x : p.x;
  int lowBin = ascending ? p.bin : q.bin;
  int highBin = ascending ? q.bin : p.bin;
  vec4 right = linearMean(ascending ? p.value : q.value, ascending ? p.binEnd : q.binEnd);
  vec4 left = linearMean(ascending ? q.binBegin : p.binBegin, ascending ? q.value : p.value);
  vec4 between = vec4((ascending ? q.integral : p.integral) - (ascending ? p.integralEnd : q.integralEnd));
#if TETMARCH_COMPONENTS
  vec4 sum = right * (real(lowBin + 1) - low) + between * table.integralUnit + left * (high - real(highBin));
#else
  vec4 sum = right * (real(lowBin + 1) - low) + between * tableIntegralUnit + left * (high - real(highBin));
#endif
  vec4 acrossBins = sum * (real(1) / max(high - low, TINY));
  vec4 withinBin = linearMean(p.value, q.value);
  return p.bin == q.bin ? withinBin : acrossBins;
}

#if TETMARCH_DEPENDENT
// The first table, that of the opacity.
vec4 tableValue(real x) { return tableValue(tableSpan(0), x); }
TablePoint tablePoint(real x) { return tablePoint(tableSpan(0), x); }
vec4 meanBetween(TablePoint p, TablePoint q) { return meanBetween(tableSpan(0), p, q); }
#endif
