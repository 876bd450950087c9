// The error of a picture of curved cells that were cut into tetrahedra. Their faces are at most curvedDeparture.x apart,
// along the ray at most that divided by |cos|, and at one place their scalars differ by at most e = curvedDeparture.y
// (Curved/CurvedDeparture.h).
//
// Let t, C, T be extinction, colour and transmittance along the ray in one medium, t', C' in the other, and R the
// radiance from behind in that. The pixels differ by the integral of T (t' (C' - R) - t (C - R)). Since C and R are in
// 0..1, a channel differs by at most the integral of T (|t' - t| + t |C' - C|). If the scalar rises by s along a
// segment, the mean of |t' - t| on it is at most 2 e / s times the variation of t over the scalars of the segment and e
// on both sides, and at most this variation; so is that of C. And it is at most e times the greatest slope of t there,
// which is at most the mean one and the variation of slopes; as is that of the difference of C t, for
// |t' (C' - R) - t (C - R)| <= |t' C' - t C| + |t' - t|.
//
// Light is not included, and neither are rays that pass the tetrahedra, but not the cells.

#if TETMARCH_POINT_SCALARS
// The variations of colour and extinction up to a position in the table, which is in this bin.
vec2 variationsUpTo(real x, int bin)
{
  vec2 begin = fetchTableVariations(bin);
  return begin + (fetchTableVariations(bin + 1) - begin) * clamp(x - real(bin), real(0), real(1));
}

// Upper bound of the error of a channel by the scalars of a segment with these extinctions at its ends.
real shiftedScalarError(Segment segment, vec2 extinctions, real thickness)
{
  real begin = segment.begin.y * tableScale + tableOffset;
  real end = segment.end.y * tableScale + tableOffset;
  real reach = abs(tableScale) * curvedDeparture.y;
  real low = min(begin, end) - reach;
  real high = max(begin, end) + reach;
  int first = tableBin(low);
  int last = tableBin(high);

  vec2 variation = variationsUpTo(high, last) - variationsUpTo(low, first);
  vec2 slopeVariation = fetchTableSlopeVariations(last + 1) - fetchTableSlopeVariations(first);
  vec4 from = tableValue(low);
  vec4 to = tableValue(high);
  real perRise = real(1) / max(high - low, TINY);
  real slope = abs(to.w - from.w) * perRise + slopeVariation.x;
  real share = min(real(2) * reach / max(abs(end - begin), TINY), real(1));
#if TETMARCH_CONSTANT_COLOR
  real byVariation = variation.y * share;
#else
  vec3 rise = abs(vec3(to.x, to.y, to.z) * to.w - vec3(from.x, from.y, from.z) * from.w);
  slope = slope + max(rise.x, max(rise.y, rise.z)) * perRise + slopeVariation.y;
  real greatest = max(extinctions.x, extinctions.y) + variation.y;
  real byVariation = (variation.y + greatest * min(variation.x, real(1))) * share;
#endif
  return min(min(byVariation, slope * reach) * thickness, real(1));
}
#endif

vec4 mediumOf(real scalar)
{
  vec4 medium = tableValue(scalar * tableScale + tableOffset);
#if TETMARCH_CONSTANT_COLOR
  medium = vec4(real(0), real(0), real(0), medium.w);
#endif
  return medium;
}

// Before a segment of the cell is integrated.
void addCurvedError(Segment segment, real thicknessPerDepth, CellInterval cell, INOUT(Radiance) radiance)
{
  vec4 begin = mediumOf(segment.begin.y);
  vec4 end = mediumOf(segment.end.y);
  real error = real(0);
  bool follows = segment.begin.x <= radiance.face.depth;
  if (!follows)
  {
    error = shiftedFaceError(radiance.face, NO_MEDIUM, radiance.transmittance);
    radiance.face = noFace();
  }
#if TETMARCH_LIT
  real bright = brightness(illuminationWithin(cell, real(0.5)));
#else
  real bright = real(0);
#endif
  radiance.face.bright = max(radiance.face.bright, bright);
  bool isAtFace = segment.begin.x <= cell.enter.x; // not at a cut
  if (isAtFace && !(follows && segment.begin.y == radiance.face.scalar))
  {
    radiance.face.shift = cell.enterShift * thicknessPerDepth;
    error = error + shiftedFaceError(radiance.face, begin, radiance.transmittance);
  }
#if TETMARCH_POINT_SCALARS
  real thickness = (segment.end.x - segment.begin.x) * thicknessPerDepth;
  error = error +
    radiance.transmittance * shiftedScalarError(segment, vec2(begin.w, end.w), thickness) * (real(1) + bright);
#endif
  radiance.curvedError = radiance.curvedError + error;
  radiance.face.depth = segment.end.x;
  radiance.face.scalar = segment.end.y;
  radiance.face.shift = segment.end.x >= cell.leave.x ? cell.leaveShift * thicknessPerDepth : real(0);
  radiance.face.medium = end;
  radiance.face.bright = bright;
}
