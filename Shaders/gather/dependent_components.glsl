// Dependent components: the first scalar gives the extinction, further ones the colour. Of four components three are
// red, green and blue; of two one gives the colour, by a table behind that of the opacity.

#if TETMARCH_POINT_SCALARS
// Positions in the opacity's table at both ends of a segment, and the scalars of the colour.
struct SegmentEnds
{
  real begin;
  real end;
  vec3 furtherBegin;
  vec3 furtherEnd;
};

SegmentEnds segmentEnds(Segment segment)
{
  SegmentEnds ends;
  ends.begin = segment.begin.y * tableScale + tableOffset;
  ends.end = segment.end.y * tableScale + tableOffset;
  ends.furtherBegin = segment.furtherBegin;
  ends.furtherEnd = segment.furtherEnd;
  return ends;
}

// Whether the table at the begin was read by the last lookup, as it mostly was.
bool isLoaded(SegmentEnds ends, CellInterval cell) { return cell.at.x == ends.begin; }

// The colour along a subsegment.
struct DependentColor
{
  vec3 color; // mean over the depth
#if TETMARCH_ERROR_BOUND
  real change; // total variation of the channel that changes most
#endif
};

DependentColor dependentColorBetween(vec3 from, vec3 to)
{
  DependentColor found;
#if TETMARCH_DIRECT_COLOR
  found.color = (from + to) * real(0.5);
#if TETMARCH_ERROR_BOUND
  vec3 rise = to - from;
  found.change = max(abs(rise.x), max(abs(rise.y), abs(rise.z)));
#endif
#else
  TableSpan table = tableSpan(1);
  TablePoint p = tablePoint(table, from.x * table.scale + table.offset);
  TablePoint q = tablePoint(table, to.x * table.scale + table.offset);
  vec4 mean = meanBetween(table, p, q); // the extinction in it is 1
  found.color = vec3(mean.x, mean.y, mean.z);
#if TETMARCH_ERROR_BOUND
  found.change = min(abs(q.variation - p.variation), real(1));
#endif
#endif
  return found;
}

struct SubsegmentMean
{
  vec4 mean;       // of C tau and tau
  TablePoint next; // the opacity's table at the subsegment's end
#if TETMARCH_ERROR_BOUND
  real change; // of the colour
#endif
};

// Unless loaded, of the begin alone. The mean of C tau is taken for that of C times that of tau.
SubsegmentMean meanOfSubsegment(SegmentEnds ends, Subsegment part, bool loaded, CellInterval cell)
{
  SubsegmentMean found;
  real target = part.last ? ends.end : ends.begin + (ends.end - ends.begin) * part.end;
  found.next = tablePoint(loaded ? target : ends.begin);
  vec4 mean = meanBetween(cell.at, found.next);
  vec3 rise = ends.furtherEnd - ends.furtherBegin;
  DependentColor dependent = dependentColorBetween(
    ends.furtherBegin + rise * part.begin, ends.furtherBegin + rise * (part.begin + part.fraction));
  vec3 color = dependent.color;
  found.mean = vec4(color.x * mean.w, color.y * mean.w, color.z * mean.w, mean.w);
#if TETMARCH_ERROR_BOUND
  found.change = dependent.change;
#endif
  return found;
}

void keepTablePoint(SubsegmentMean found, INOUT(CellInterval) cell) { cell.at = found.next; }

#if TETMARCH_ERROR_BOUND
// What a subsegment loses, seen through that transmittance. The mean of C tau over that of tau differs from the mean of
// C by the covariance of both over the mean of tau: at most a quarter of the product of their ranges (Gruess 1935). The
// order of the colours (gather/order_error.glsl) is lost besides. And what is emitted has a mean of the subsegment's
// colours, as the exact emission has, so that both together are no more than the variation of the colour times what is
// absorbed.
real subsegmentError(
  SegmentEnds ends, Subsegment part, SubsegmentMean found, Absorption by, CellInterval cell, real transmittance)
{
  real spread = abs(found.next.extinctionVariation - cell.at.extinctionVariation);
  real covariance = by.absorbed * real(0.25) * spread / max(found.mean.w, TINY);
  return transmittance * (found.change * min(by.absorbed, orderErrorFactor(by.depth) + covariance));
}
#endif
#else
vec3 dependentColorOf(vec3 further)
{
#if TETMARCH_DIRECT_COLOR
  return further;
#else
  TableSpan table = tableSpan(1);
  vec4 value = tableValue(table, further.x * table.scale + table.offset);
  return vec3(value.x, value.y, value.z);
#endif
}

// C tau and tau where the scalars are constant.
vec4 constantMean(Segment segment)
{
  vec4 value = tableValue(segment.begin.y * tableScale + tableOffset);
  vec3 color = dependentColorOf(segment.furtherBegin);
  return vec4(color.x * value.w, color.y * value.w, color.z * value.w, value.w);
}
#endif
