// Means between two points of the table. The first is usually kept from the last interval: half the reads of
// interval_mean.glsl, but more registers.

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
#if TETMARCH_ERROR_BOUND || TETMARCH_SLOPE_VARIATION
  real colorRise;   // the maximum change of a channel of C in the bin
#endif
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

// The point x in a bin with the given first entry.
TablePoint pointInBin(real x, int bin, int entry)
{
  TablePoint p;
  p.x = x;
  p.bin = bin;
  p.binBegin = fetchTableValue(entry);
  p.binEnd = fetchTableValue(entry + 1);
  p.integral = fetchTableIntegral(entry + entryNextTo(x - real(bin)));
  BinPoint place = binPoint(p.binBegin, p.binEnd, x - real(bin));
  p.value = place.value;
  p.area = place.area;
#if TETMARCH_ERROR_BOUND || TETMARCH_SLOPE_VARIATION
  p.colorRise = place.rise;
#endif
  return p;
}

#if TETMARCH_ERROR_BOUND || TETMARCH_EXTINCTION_VARIATION
// The fraction of its bin before the point, 0..1.
real fractionOfBin(TablePoint p) { return clamp(p.x - real(p.bin), real(0), real(1)); }
#endif

#if TETMARCH_COMPONENTS
TablePoint tablePoint(TableSpan table, real x)
{
  int bin = tableBin(table, x);
  int entry = table.first + bin;
  TablePoint p = pointInBin(x, bin, entry);
#if TETMARCH_ERROR_BOUND
  vec2 variation = fetchTableVariations(entry);
  p.variation = variation.x + p.colorRise * fractionOfBin(p);
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
  p.variation = variation.x + p.colorRise * fractionOfBin(p);
#endif
  p.extinctionVariation = variation.y + abs(p.binEnd.w - p.binBegin.w) * fractionOfBin(p);
#if TETMARCH_SLOPE_VARIATION
  // In a bin tau is linear, and C tau a parabola.
  vec2 slopeVariation = fetchTableSlopeVariations(bin);
  p.slopeVariation = vec2(slopeVariation.x,
    slopeVariation.y + real(2) * abs(p.binEnd.w - p.binBegin.w) * p.colorRise * fractionOfBin(p));
#endif
#elif TETMARCH_ERROR_BOUND
  p.variation = fetchTableVariation(bin) + p.colorRise * fractionOfBin(p);
#endif
  return p;
}
#endif

// The mean for C and tau linear from p to m along one part of the interval, and from there to q along the other.
vec4 meanAround(vec4 p, vec4 m, vec4 q, real before, real behind)
{
  real first = before * (real(1) / real(6));
  real second = behind * (real(1) / real(6));
  real wp = (real(2) * p.w + m.w) * first;
  real wm = (p.w + real(2) * m.w) * first + (real(2) * m.w + q.w) * second;
  real wq = (m.w + real(2) * q.w) * second;
  return vec4(p.x * wp + m.x * wm + q.x * wq, p.y * wp + m.y * wm + q.y * wq, p.z * wp + m.z * wm + q.z * wq,
    real(3) * ((p.w + m.w) * first + (m.w + q.w) * second));
}

// Over the scalars between two points of the table. Entries between them are those of q.
#if TETMARCH_COMPONENTS
IntervalMean meanBetween(TableSpan table, TablePoint p, TablePoint q)
{
  vec4 integralUnit = table.integralUnit;
#else
IntervalMean meanBetween(TablePoint p, TablePoint q)
{
  vec4 integralUnit = tableIntegralUnit;
#endif
  IntervalMean found;
  bool sameBin = p.bin == q.bin;
  bool ascending = p.bin < q.bin;
  bool isLong = abs(p.bin - q.bin) > 1;
  real perRise = real(1) / (sameBin ? real(1) : q.x - p.x);
  // In one bin or in two adjacent ones: linear up to the entry between them, and after it.
  vec4 middle = sameBin ? q.value : (ascending ? q.binBegin : q.binEnd);
  real entry = real(max(p.bin, q.bin));
  real before = sameBin ? real(1) : (entry - p.x) * perRise;
  real behind = sameBin ? real(0) : (q.x - entry) * perRise;
  vec4 straight = meanAround(p.value, middle, q.value, before, behind);
  // Otherwise the interval is longer than a bin. For tiny integrals their steps are significant.
  vec4 entries = vec4(ascending ? q.integral - p.integral : p.integral - q.integral) * integralUnit;
  vec4 mean = entries * abs(perRise) + (q.area - p.area) * perRise;
  vec4 acrossBins = vec4(max(mean.x, real(0)), max(mean.y, real(0)), max(mean.z, real(0)), max(mean.w, real(0)));
  found.mean = isLong ? acrossBins : straight;
#if TETMARCH_ERROR_BOUND
  found.variation = abs(q.variation - p.variation);
#endif
#if TETMARCH_EXTINCTION_VARIATION
  found.extinctionVariation = abs(q.extinctionVariation - p.extinctionVariation);
#endif
#if TETMARCH_ERROR_BOUND && TETMARCH_INDEPENDENT
  found.ends = p.value + q.value;
#endif
#if TETMARCH_TABLE_ERROR && !TETMARCH_INDEPENDENT
  found.perBins = isLong ? abs(perRise) : real(0);
#endif
  return found;
}

#if TETMARCH_COMPONENTS
IntervalMean meanOver(TableSpan table, real p, real q)
{
  return meanBetween(table, tablePoint(table, p), tablePoint(table, q));
}
#if TETMARCH_DEPENDENT
// Of the first table, that of the opacity.
TablePoint tablePoint(real x) { return tablePoint(tableSpan(0), x); }
IntervalMean meanBetween(TablePoint p, TablePoint q) { return meanBetween(tableSpan(0), p, q); }
IntervalMean meanOver(real p, real q) { return meanOver(tableSpan(0), p, q); }
#endif
#else
IntervalMean meanOver(real p, real q) { return meanBetween(tablePoint(p), tablePoint(q)); }
#endif
