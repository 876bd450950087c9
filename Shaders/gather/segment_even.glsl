// Emission and absorption along a segment of a trilinear cell, cut into equal pieces depending on the scalar's bend. No
// tolerance is guaranteed: features between the cuts, such as an extreme of the scalar, are missed.

// Maximum deviation of the scalar, 0..1, from the straight line in a piece, unless the number of pieces is at its
// limit.
CONSTANT real GREATEST_BEND = real(1) / real(256);
CONSTANT int MOST_PIECES = 8;

// The bend of a piece decreases with the square of their number.
int piecesOf(vec2 bend)
{
  real pieces = -floor(-sqrt(greatestBend(bend) / GREATEST_BEND));
  return clamp(int(max(real(1), min(pieces, real(MOST_PIECES)))), 1, MOST_PIECES);
}

// The correction of the mean for the bend, valid for a straight function. Across a narrow peak it is meaningless: so it
// is limited to half of the difference of the ends.
vec4 meanOfPiece(IntegralPoint from, IntegralPoint to, vec2 bend)
{
  real share = clamp(bentShare(bend, to.x - from.x), real(-0.5), real(0.5));
  vec4 mean = meanByDifference(from, to) + (to.rise - from.rise) * tableIntegralUnit * share;
  return vec4(max(mean.x, real(0)), max(mean.y, real(0)), max(mean.z, real(0)), max(mean.w, real(0)));
}

#if TETMARCH_ERROR_BOUND
// Upper bound of the colour error, attenuated by the transmittance. Both the piece's true mean extinction and that of
// the table are within the range of the piece's scalars, and so are the colours; the correction adds at most half of
// the difference of the extinctions.
real errorOfPiece(IntegralPoint from, IntegralPoint to, vec2 bend, Absorption by, real transmittance)
{
  real reach = greatestBend(bend);
  vec2 low = fetchTableVariations(tableBin(min(from.x, to.x) - reach));
  vec2 high = fetchTableVariations(tableBin(max(from.x, to.x) + reach) + 1);
  return transmittance *
    (min(real(1.5) * by.thickness * (high.y - low.y), real(1)) + min(high.x - low.x, real(1)) * by.absorbed);
}
#endif

// Along a thickness in scalar opacity unit distances. Returns the number of pieces.
int integrateSegment(Segment segment, real thickness, INOUT(CellInterval) cell, INOUT(Radiance) radiance)
{
  real begin = segment.begin.y * tableScale + tableOffset;
  real end = segment.end.y * tableScale + tableOffset;
  vec2 bend = segment.bend * tableScale;
  int count = piecesOf(segment.bend);
  real step = real(1) / real(count);
  IntegralPoint from = integralPoint(begin);
  int pieces = 0;
  do
  {
    real position = real(pieces) * step;
    real next = position + step;
    bool last = pieces + 1 >= count;
    IntegralPoint to = integralPoint(last ? end : bentScalar(begin, end, bend, next));
    vec4 mean = meanOfPiece(from, to, bendWithin(bend, position, next));
    real middle = position + real(0.5) * step;
    Absorption by = absorption(mean, thicknessWithin(cell, middle, step * thickness));
#if TETMARCH_ERROR_BOUND
    real error = errorOfPiece(from, to, bendWithin(bend, position, next), by, radiance.transmittance);
#if TETMARCH_LIT
    error = error * brightness(illuminationWithin(cell, middle));
#endif
    radiance.error = radiance.error + error;
#endif
#if TETMARCH_TABLE_ERROR
    addLookup(perBinsBetween(from, to), by, middle, cell, radiance);
#endif
    addSubsegment(mean, by, middle, step, cell, radiance);
    from = to;
    pieces = pieces + 1;
  } while (pieces < count);
  return pieces;
}
