// Independent components: clouds of particles in the same space, each with its own scalar, colours and extinction.
// Their extinctions add, and so do their emissions (Max, "Optical models", 1995).

vec4 scalarsOf(real first, vec3 extra) { return vec4(first, extra.x, extra.y, extra.z); }

real componentOf(vec4 v, int k) { return k == 0 ? v.x : (k == 1 ? v.y : (k == 2 ? v.z : v.w)); }

#if TETMARCH_POINT_SCALARS
// The scalars at both ends of a segment.
struct SegmentEnds
{
  vec4 begin;
  vec4 end;
#if TETMARCH_BENT
  vec4 square; // their bends: structured/bend.glsl
  vec4 cube;
#endif
#if TETMARCH_LIT_COMPONENTS
  vec2 depths;
#endif
};

SegmentEnds segmentEnds(Segment segment)
{
  SegmentEnds ends;
  ends.begin = scalarsOf(segment.begin.y, segment.extraBegin);
  ends.end = scalarsOf(segment.end.y, segment.extraEnd);
#if TETMARCH_BENT
  ends.square = scalarsOf(segment.bend.x, segment.extraBend.square);
  ends.cube = scalarsOf(segment.bend.y, segment.extraBend.cube);
#endif
#if TETMARCH_LIT_COMPONENTS
  ends.depths = vec2(segment.begin.x, segment.end.x);
#endif
  return ends;
}

#if TETMARCH_BENT || TETMARCH_LIT_COMPONENTS
// The scalars at a fraction of the segment.
vec4 scalarsWithin(SegmentEnds ends, real x)
{
#if TETMARCH_BENT
  return ends.begin + (ends.end - ends.begin) * x - (ends.square + ends.cube * (real(1) + x)) * (x * (real(1) - x));
#else
  return ends.begin + (ends.end - ends.begin) * x;
#endif
}

// The ends of a part of a segment.
SegmentEnds endsWithin(SegmentEnds ends, Subsegment part)
{
  real h = part.fraction;
  SegmentEnds within;
  within.begin = scalarsWithin(ends, part.begin);
  within.end = part.last ? ends.end : scalarsWithin(ends, part.end);
#if TETMARCH_BENT
  within.square = (ends.square + ends.cube * (real(3) * part.begin)) * (h * h);
  within.cube = ends.cube * (h * h * h);
#endif
#if TETMARCH_LIT_COMPONENTS
  real begin = ends.depths.x + (ends.depths.y - ends.depths.x) * part.begin;
  within.depths = vec2(begin, begin + (ends.depths.y - ends.depths.x) * h);
#endif
  return within;
}
#endif

struct SubsegmentMean
{
  vec4 mean; // of C tau and tau, summed over the components
#if TETMARCH_ERROR_BOUND
  real change; // upper bound of the change of the mixture's colour
#if TETMARCH_BENT
  IndependentBend bent;
#endif
#if TETMARCH_LIT_COMPONENTS
  real bright; // the greatest colour of a component in light, at least 1
#endif
#endif
};

#if TETMARCH_TABLE_ERROR
// Each component has its own; no mean is over less than a bin.
real perBinsOf(SubsegmentMean found) { return real(1); }
#endif

#if TETMARCH_ERROR_BOUND && !TETMARCH_STRUCTURED
real greatestOf(vec3 v) { return max(v.x, max(v.y, v.z)); }
#endif

// The means are those of the components' tables, exactly; only the order of the colours of the mixture, C = sum(tau_i
// C_i) / sum(tau_i), is lost. In its bound the range of C replaces its variation in gather/order_error.glsl: the
// integral of C(u) (exp(-u) - phi) is maximal for the maximum of C where the factor is positive and the minimum
// elsewhere, and the integral of the positive part of the factor is the maximum of H. C changes with the colours and
// with the proportions of the components. Let m_i be the middle of a component's colours, R_i their range, S the range
// of all m_i; let tau_i stay within E_i of its middle t_i. Then
//   |C(x) - C(y)| <= max(R_i) + S sum|w_i(x) - w_i(y)| / 2,  w_i = tau_i / sum(tau_i),
// since the sum of the w_i is 1, so that only differences of the m_i count; and since
//   sum|w_i - t_i / sum(t_i)| <= 2 sum(E_i) / sum(tau_i) <= 2 sum(E_i) / (sum(t_i) - sum(E_i)),
// the proportions change by at most 2 sum(E_i) / (sum(t_i) - sum(E_i)), and by at most 1. A function from p to q with
// the total variation V stays within V / 2 of (p + q) / 2, so these are the middles, and R_i = V_i.
// Light is that in the middle.
#if TETMARCH_LIT_COMPONENTS
SubsegmentMean independentMeanBetween(SegmentEnds part, CellInterval cell)
{
  vec4 from = part.begin;
  vec4 to = part.end;
#elif TETMARCH_BENT
SubsegmentMean independentMeanBetween(SegmentEnds part)
{
  vec4 from = part.begin;
  vec4 to = part.end;
#else
SubsegmentMean independentMeanBetween(vec4 from, vec4 to)
{
#endif
  SubsegmentMean found;
  found.mean = vec4(real(0), real(0), real(0), real(0));
#if TETMARCH_ERROR_BOUND
  real extinction = real(0); // sum(t_i)
  real spread = real(0);     // 2 sum(E_i)
  real range = real(0);      // max(R_i)
  vec3 low = vec3(NO_DEPTH, NO_DEPTH, NO_DEPTH);
  vec3 high = vec3(real(0), real(0), real(0));
#if TETMARCH_BENT
  found.bent = noBend();
#endif
#if TETMARCH_LIT_COMPONENTS
  found.bright = real(1);
#endif
#endif
  for (int k = 0; k < componentCount; ++k)
  {
    TableSpan table = tableSpan(k);
    real factor = componentOf(componentFactor, k);
    IntervalMean over = meanOver(table, componentOf(from, k) * table.scale + table.offset,
      componentOf(to, k) * table.scale + table.offset);
    vec4 mean = over.mean * factor;
#if TETMARCH_LIT_COMPONENTS
    Light light = lightOfComponent(k, cell, real(0.5) * (part.depths.x + part.depths.y));
    found.mean = found.mean + litMean(mean, light);
#else
    found.mean = found.mean + mean;
#endif
#if TETMARCH_ERROR_BOUND
    bool seen = mean.w > real(0);
    vec3 middle = vec3(over.ends.x, over.ends.y, over.ends.z) * real(0.5);
#if TETMARCH_LIT_COMPONENTS
    middle = middle * light.diffuse + light.specular;
    range = max(range, seen ? over.variation * greatestOf(light.diffuse) : real(0));
    found.bright = max(found.bright, greatestOf(light.diffuse + light.specular));
#else
    range = max(range, seen ? over.variation : real(0));
#endif
    extinction = extinction + over.ends.w * real(0.5) * factor;
    spread = spread + over.extinctionVariation * factor;
    low = vec3(seen ? min(low.x, middle.x) : low.x, seen ? min(low.y, middle.y) : low.y,
      seen ? min(low.z, middle.z) : low.z);
    high = vec3(seen ? max(high.x, middle.x) : high.x, seen ? max(high.y, middle.y) : high.y,
      seen ? max(high.z, middle.z) : high.z);
#if TETMARCH_BENT
    addBend(over, greatestShift(vec2(componentOf(part.square, k), componentOf(part.cube, k)),
      componentOf(to, k) - componentOf(from, k)), factor, found.bent);
#endif
#endif
  }
#if TETMARCH_ERROR_BOUND
  real least = extinction - real(0.5) * spread;
  real proportions = spread < least ? spread / max(least, TINY) : real(1);
#if TETMARCH_LIT_COMPONENTS
  real most = found.bright;
#else
  real most = real(1);
#endif
  found.change = min(range + max(greatestOf(high - low), real(0)) * proportions, most);
#endif
  return found;
}

SubsegmentMean meanOfSubsegment(SegmentEnds ends, Subsegment part, bool loaded, CellInterval cell)
{
#if TETMARCH_LIT_COMPONENTS
  return independentMeanBetween(endsWithin(ends, part), cell);
#elif TETMARCH_BENT
  return independentMeanBetween(endsWithin(ends, part));
#else
  vec4 target = part.last ? ends.end : ends.begin + (ends.end - ends.begin) * part.end;
  return independentMeanBetween(ends.begin + (ends.end - ends.begin) * part.begin, target);
#endif
}

#if TETMARCH_ERROR_BOUND
// Upper bound of a subsegment's error, attenuated by the transmittance.
real subsegmentError(
  SegmentEnds ends, Subsegment part, SubsegmentMean found, Absorption by, CellInterval cell, real transmittance)
{
#if TETMARCH_LIT_COMPONENTS && !TETMARCH_BENT
  return transmittance * min(found.change * orderErrorFactor(by.depth), found.bright);
#elif TETMARCH_LIT_COMPONENTS
  return transmittance *
    min(found.change * orderErrorFactor(by.depth) + found.bright * independentBend(found.bent, by), found.bright);
#elif TETMARCH_BENT
  return transmittance * min(found.change * orderErrorFactor(by.depth) + independentBend(found.bent, by), real(1));
#else
  return transmittance * found.change * orderErrorFactor(by.depth);
#endif
}
#endif
#else
// C tau and tau of the mixture for constant scalars.
#if TETMARCH_LIT_COMPONENTS
vec4 constantMean(Segment segment, CellInterval cell)
#else
vec4 constantMean(Segment segment)
#endif
{
  vec4 scalars = scalarsOf(segment.begin.y, segment.extraBegin);
  vec4 sum = vec4(real(0), real(0), real(0), real(0));
  for (int k = 0; k < componentCount; ++k)
  {
    TableSpan table = tableSpan(k);
    vec4 value = tableValue(table, componentOf(scalars, k) * table.scale + table.offset);
    vec4 own = vec4(value.x * value.w, value.y * value.w, value.z * value.w, value.w);
#if TETMARCH_LIT_COMPONENTS
    own = litMean(own, lightOfComponent(k, cell, real(0.5) * (segment.begin.x + segment.end.x)));
#endif
    sum = sum + own * componentOf(componentFactor, k);
  }
  return sum;
}
#endif
