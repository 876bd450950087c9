// Dependent components: the first scalar determines the extinction, extra ones the colour. Of four components three
// are red, green and blue; of two, one determines the colour, by a table after that of the opacity.

#if TETMARCH_POINT_SCALARS
// Positions in the opacity's table at both ends of a segment, and the scalars of the colour.
struct SegmentEnds
{
  real begin;
  real end;
  vec3 extraBegin;
  vec3 extraEnd;
#if TETMARCH_BENT
  vec2 bend; // between the positions
  ExtraBend extraBend;
#endif
};

SegmentEnds segmentEnds(Segment segment)
{
  SegmentEnds ends;
  ends.begin = segment.begin.y * tableScale + tableOffset;
  ends.end = segment.end.y * tableScale + tableOffset;
  ends.extraBegin = segment.extraBegin;
  ends.extraEnd = segment.extraEnd;
#if TETMARCH_BENT
  ends.bend = segment.bend * tableScale;
  ends.extraBend = segment.extraBend;
#endif
  return ends;
}

// The colour along a subsegment.
struct DependentColor
{
  vec3 color; // mean over the depth
#if TETMARCH_ERROR_BOUND
  real change; // total variation of the channel with the largest change
#if TETMARCH_BENT
  real bendShift; // of the colour's scalar, unless the mean is exact
#endif
#endif
};

#if TETMARCH_BENT
DependentColor dependentColorBetween(vec3 from, vec3 to, ExtraBend bend)
#else
DependentColor dependentColorBetween(vec3 from, vec3 to)
#endif
{
  DependentColor found;
#if TETMARCH_DIRECT_COLOR
  found.color = (from + to) * real(0.5);
#if TETMARCH_BENT
  found.color = found.color - bend.square * (real(1) / real(6)) - bend.cube * real(0.25);
#endif
#if TETMARCH_ERROR_BOUND
  vec3 rise = to - from;
#if TETMARCH_BENT
  found.change = max(
    bentVariation(rise.x, bend.square.x, bend.cube.x), max(bentVariation(rise.y, bend.square.y, bend.cube.y),
    bentVariation(rise.z, bend.square.z, bend.cube.z)));
  found.bendShift = real(0);
#else
  found.change = max(abs(rise.x), max(abs(rise.y), abs(rise.z)));
#endif
#endif
#else
  TableSpan table = tableSpan(1);
  IntervalMean over = meanOver(table, from.x * table.scale + table.offset, to.x * table.scale + table.offset);
  found.color = vec3(over.mean.x, over.mean.y, over.mean.z); // the extinction is 1
#if TETMARCH_ERROR_BOUND
  found.change = min(over.variation, real(1));
#if TETMARCH_BENT
  found.bendShift = greatestShift(vec2(bend.square.x, bend.cube.x), to.x - from.x);
#endif
#endif
#endif
  return found;
}

struct SubsegmentMean
{
  vec4 mean; // of C tau and tau
  IntervalMean over; // of the opacity's table
#if TETMARCH_KEEPS_TABLE_POINT
  TablePoint next; // that table at the subsegment's end
#endif
#if TETMARCH_ERROR_BOUND
  real change; // of the colour
#if TETMARCH_BENT
  real bendShift;
#endif
#endif
};

// Unless loaded, of the begin only. The mean of C tau is approximated by the product of the means of C and tau.
SubsegmentMean meanOfSubsegment(SegmentEnds ends, Subsegment part, bool loaded, CellInterval cell)
{
  SubsegmentMean found;
#if TETMARCH_BENT
  real target = part.last ? ends.end : bentScalar(ends.begin, ends.end, ends.bend, part.end);
#else
  real target = part.last ? ends.end : ends.begin + (ends.end - ends.begin) * part.end;
#endif
#if TETMARCH_KEEPS_TABLE_POINT
  found.next = tablePoint(loaded ? target : ends.begin);
  found.over = meanBetween(cell.at, found.next);
#else
  found.over = meanOver(ends.begin + (ends.end - ends.begin) * part.begin, target);
#endif
  vec4 mean = found.over.mean;
#if TETMARCH_BENT
  real until = part.begin + part.fraction;
  DependentColor dependent =
    dependentColorBetween(bentScalars(ends.extraBegin, ends.extraEnd, ends.extraBend, part.begin),
      bentScalars(ends.extraBegin, ends.extraEnd, ends.extraBend, until),
      extraBendWithin(ends.extraBend, part.begin, until));
#else
  vec3 rise = ends.extraEnd - ends.extraBegin;
  DependentColor dependent = dependentColorBetween(
    ends.extraBegin + rise * part.begin, ends.extraBegin + rise * (part.begin + part.fraction));
#endif
  vec3 color = dependent.color;
  found.mean = vec4(color.x * mean.w, color.y * mean.w, color.z * mean.w, mean.w);
#if TETMARCH_ERROR_BOUND
  found.change = dependent.change;
#if TETMARCH_BENT
  found.bendShift = dependent.bendShift;
#endif
#endif
  return found;
}

#if TETMARCH_TABLE_ERROR
real perBinsOf(SubsegmentMean found) { return found.over.perBins; }
#endif

#if TETMARCH_ERROR_BOUND
// Upper bound of a subsegment's error, attenuated by the transmittance. The mean of C tau over that of tau differs from
// the mean of C by the covariance of both over the mean of tau: at most a quarter of the product of their ranges
// (Gruess 1935). In addition, the order of the colours is lost (gather/order_error.glsl). The emission is a mean of the
// subsegment's colours, like the exact emission, so that the sum of both errors is at most the variation of the colour
// times the absorption. structured/component_bend.glsl adds the effect of the scalars' bends.
real subsegmentError(
  SegmentEnds ends, Subsegment part, SubsegmentMean found, Absorption by, CellInterval cell, real transmittance)
{
  real spread = found.over.extinctionVariation;
  real covariance = by.absorbed * real(0.25) * spread / max(found.mean.w, TINY);
#if TETMARCH_BENT
  DependentBend bent =
    dependentBend(bendWithin(ends.bend, part.begin, part.begin + part.fraction), found.next.x - cell.at.x, by, spread);
  return transmittance * (bent.opacity + min(found.change, real(1)) * min(by.absorbed,
    orderErrorFactor(by.depth) + covariance + bent.light + found.bendShift * bent.perRatio));
#else
  return transmittance * (found.change * min(by.absorbed, orderErrorFactor(by.depth) + covariance));
#endif
}
#endif
#else
vec3 dependentColorOf(vec3 extra)
{
#if TETMARCH_DIRECT_COLOR
  return extra;
#else
  TableSpan table = tableSpan(1);
  vec4 value = tableValue(table, extra.x * table.scale + table.offset);
  return vec3(value.x, value.y, value.z);
#endif
}

// C tau and tau for constant scalars.
vec4 constantMean(Segment segment)
{
  vec4 value = tableValue(segment.begin.y * tableScale + tableOffset);
  vec3 color = dependentColorOf(segment.extraBegin);
  return vec4(color.x * value.w, color.y * value.w, color.z * value.w, value.w);
}
#endif
