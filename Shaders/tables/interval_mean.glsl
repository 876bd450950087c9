// Means over intervals whose two ends are read one after the other, in the order that takes the fewest registers of a
// GPU (Documentation/GpuCompile.md). The formulas are those of table_points.glsl.

// One end of the interval.
struct IntervalEnd
{
  BinPoint point;
#if TETMARCH_ERROR_BOUND
  real variation; // V up to it
#endif
#if TETMARCH_EXTINCTION_VARIATION
  real extinctionVariation; // the same of tau
#endif
};

// x: from the begin of a bin with the given first entry.
IntervalEnd intervalEnd(real x, int entry)
{
  IntervalEnd found;
  vec4 begin = fetchTableValue(entry);
  vec4 end = fetchTableValue(entry + 1);
  found.point = binPoint(begin, end, x);
#if TETMARCH_EXTINCTION_VARIATION
  real fraction = clamp(x, real(0), real(1));
  vec2 variations = fetchTableVariations(entry);
  found.extinctionVariation = variations.y + abs(end.w - begin.w) * fraction;
#if TETMARCH_ERROR_BOUND
  found.variation = variations.x + found.point.rise * fraction;
#endif
#elif TETMARCH_ERROR_BOUND
  found.variation = fetchTableVariation(entry) + found.point.rise * clamp(x, real(0), real(1));
#endif
  return found;
}

// All but the mean.
IntervalMean spanOf(IntervalEnd p, IntervalEnd q)
{
  IntervalMean found;
  found.mean = vec4(real(0), real(0), real(0), real(0));
#if TETMARCH_ERROR_BOUND
  found.variation = abs(q.variation - p.variation);
#endif
#if TETMARCH_EXTINCTION_VARIATION
  found.extinctionVariation = abs(q.extinctionVariation - p.extinctionVariation);
#endif
#if TETMARCH_ERROR_BOUND && TETMARCH_INDEPENDENT
  found.ends = p.point.value + q.point.value;
#endif
  return found;
}

// From p to q, each in its bin of the table whose first entry is given.
IntervalMean meanOfBins(real p, int pBin, real q, int qBin, int first, vec4 integralUnit)
{
  IntervalMean found;
  bool sameBin = pBin == qBin;
  real perRise = real(1) / (sameBin ? real(1) : q - p);
  real fromBin = p - real(pBin);
  real toBin = q - real(qBin);
  bool isLong = abs(pBin - qBin) > 1;
  if (isLong)
  {
    IntervalEnd to = intervalEnd(toBin, first + qBin);
    IntervalEnd from = intervalEnd(fromBin, first + pBin);
    found = spanOf(from, to);
    vec4 mean = (to.point.area - from.point.area) * perRise;
    uvec4 at = fetchTableIntegral(first + pBin + entryNextTo(fromBin));
    uvec4 until = fetchTableIntegral(first + qBin + entryNextTo(toBin));
    mean = vec4(pBin < qBin ? until - at : at - until) * integralUnit * abs(perRise) + mean;
    found.mean = vec4(max(mean.x, real(0)), max(mean.y, real(0)), max(mean.z, real(0)), max(mean.w, real(0)));
  }
  else
  {
    IntervalEnd to = intervalEnd(toBin, first + qBin);
    int entry = max(pBin, qBin);
    vec4 middle = sameBin ? to.point.value : fetchTableValue(first + entry);
    vec4 behind = linearMean(middle, to.point.value) * (sameBin ? real(0) : (q - real(entry)) * perRise);
    IntervalEnd from = intervalEnd(fromBin, first + pBin);
    found = spanOf(from, to);
    found.mean =
      linearMean(from.point.value, middle) * (sameBin ? real(1) : (real(entry) - p) * perRise) + behind;
  }
#if TETMARCH_TABLE_ERROR && !TETMARCH_INDEPENDENT
  found.perBins = isLong ? abs(perRise) : real(0);
#endif
  return found;
}

#if TETMARCH_COMPONENTS
IntervalMean meanOver(TableSpan table, real p, real q)
{
  return meanOfBins(p, tableBin(table, p), q, tableBin(table, q), table.first, table.integralUnit);
}
#if TETMARCH_DEPENDENT
IntervalMean meanOver(real p, real q) { return meanOver(tableSpan(0), p, q); } // of the opacity
#endif
#else
IntervalMean meanOver(real p, real q) { return meanOfBins(p, tableBin(p), q, tableBin(q), 0, tableIntegralUnit); }
#endif
