// One scalar determines colour and extinction.

#if TETMARCH_POINT_SCALARS && !TETMARCH_POINT_SAMPLED && !TETMARCH_EVEN_CUTS
// Positions in the table at both ends of a segment.
struct SegmentEnds
{
  real begin;
  real end;
#if TETMARCH_BENT
  vec2 bend; // between them
#endif
};

SegmentEnds segmentEnds(Segment segment)
{
  SegmentEnds ends;
  ends.begin = segment.begin.y * tableScale + tableOffset;
  ends.end = segment.end.y * tableScale + tableOffset;
#if TETMARCH_BENT
  ends.bend = segment.bend * tableScale;
#endif
  return ends;
}

// The position at a fraction of the segment.
real positionWithin(SegmentEnds ends, real fraction)
{
#if TETMARCH_BENT
  return bentScalar(ends.begin, ends.end, ends.bend, fraction);
#else
  return ends.begin + (ends.end - ends.begin) * fraction;
#endif
}

struct SubsegmentMean
{
  vec4 mean; // of C tau and tau
  IntervalMean over;
#if TETMARCH_KEEPS_TABLE_POINT
  TablePoint next; // the table at the subsegment's end
#endif
#if TETMARCH_BENT
  vec2 bend;      // of the scalar in it
#endif
#if TETMARCH_SLOPE_VARIATION
  real bentError; // error of the light per unit of thickness, if the mean takes the bend into account; else -1
#endif
};

#if TETMARCH_SLOPE_VARIATION
vec4 weightedByExtinction(vec4 value)
{
  return vec4(value.x * value.w, value.y * value.w, value.z * value.w, value.w);
}

// Takes the bend into account if the functions are straight enough for an error bound.
void bendMean(TablePoint from, INOUT(SubsegmentMean) found)
{
  real rise = found.next.x - from.x;
  real ofExtinction = abs(found.next.slopeVariation.x - from.slopeVariation.x);
  real ofEmission = abs(found.next.slopeVariation.y - from.slopeVariation.y);
  // An error of the optical depth changes the opacity and, as that of C tau, the colour.
  real error = bentMeanError(found.bend, rise) * (real(2) * ofExtinction + ofEmission);
  bool straight = error < greatestShift(found.bend, rise) * found.over.extinctionVariation;
  vec4 alongCubic = bentMean(
    found.mean, weightedByExtinction(from.value), weightedByExtinction(found.next.value), found.bend, rise);
  found.mean = straight ? alongCubic : found.mean;
  found.bentError = straight ? error : real(-1);
}
#endif

// Unless loaded, of the begin only.
SubsegmentMean meanOfSubsegment(SegmentEnds ends, Subsegment part, bool loaded, CellInterval cell)
{
  SubsegmentMean found;
  real target = part.last ? ends.end : positionWithin(ends, part.end);
#if TETMARCH_KEEPS_TABLE_POINT
  found.next = tablePoint(loaded ? target : ends.begin);
  found.over = meanBetween(cell.at, found.next);
#else
  found.over = meanOver(positionWithin(ends, part.begin), target);
#endif
  found.mean = found.over.mean;
#if TETMARCH_BENT
  found.bend = bendWithin(ends.bend, part.begin, part.begin + part.fraction);
#endif
#if TETMARCH_SLOPE_VARIATION
  bendMean(cell.at, found);
#endif
  return found;
}

#if TETMARCH_TABLE_ERROR
real perBinsOf(SubsegmentMean found) { return found.over.perBins; }
#endif

#if TETMARCH_ERROR_BOUND
// Upper bound of a subsegment's error (gather/order_error.glsl), attenuated by the transmittance.
real subsegmentError(
  SegmentEnds ends, Subsegment part, SubsegmentMean found, Absorption by, CellInterval cell, real transmittance)
{
#if TETMARCH_PICKED
  real variation = real(0); // of the colour; unused by picks
#else
  real variation = found.over.variation;
#endif
#if TETMARCH_BENT
  real unbent = bendError(found.bend, found.next.x - cell.at.x, by, variation,
    found.over.extinctionVariation);
  real bent = found.bentError < real(0) ? unbent : min(by.thickness * found.bentError, real(1));
  return transmittance * (min(variation, real(1)) * orderErrorFactor(by.depth) + bent);
#else
  return transmittance * (min(variation, real(1)) * orderErrorFactor(by.depth));
#endif
}
#endif
#elif !TETMARCH_EVEN_CUTS
// C tau and tau for a constant scalar.
vec4 constantMean(Segment segment)
{
  vec4 value = tableValue(segment.begin.y * tableScale + tableOffset);
  return vec4(value.x * value.w, value.y * value.w, value.z * value.w, value.w);
}
#endif
