// A part of a segment that is integrated in one step.

#if TETMARCH_POINT_SCALARS && !TETMARCH_POINT_SAMPLED && !TETMARCH_EVEN_CUTS
struct Subsegment
{
  real begin;    // position in the segment, 0..1
  real end;
  real fraction; // of the segment
  real pieces;   // number of pieces of this size in the rest of the segment
  bool last;     // it reaches the end
};

// The first of `pieces` equal pieces of the rest of the segment.
Subsegment subsegmentFrom(real position, real pieces)
{
  Subsegment part;
  part.begin = position;
  part.last = !(pieces > real(1));
  part.pieces = part.last ? real(1) : pieces;
  part.fraction = (real(1) - position) / part.pieces;
  part.end = position + part.fraction;
  return part;
}
#endif

// A thickness times the gradients' factor of the extinction at a fraction of the segment.
real thicknessWithin(CellInterval cell, real fraction, real thickness)
{
#if TETMARCH_GRADIENT_OPACITY
  return thickness * densityWithin(cell, fraction);
#else
  return thickness;
#endif
}

#if TETMARCH_TABLE_ERROR
// Records the lookup of a mean over a number of bins.
void addLookup(real perBins, Absorption by, real middle, CellInterval cell, INOUT(Radiance) radiance)
{
  real seen = radiance.transmittance * by.thickness * perBins;
#if TETMARCH_LIT
  // The background and reflections of white surfaces are assumed to be at most 1.
  seen = seen * (real(1) + brightness(illuminationWithin(cell, middle)));
#endif
  radiance.lookedUp = radiance.lookedUp + seen;
}
#endif

// Adds a subsegment to the radiance. mean: of C tau and tau; middle: position of the subsegment's middle in the
// segment; fraction: its fraction of the segment.
void addSubsegment(
  vec4 mean, Absorption by, real middle, real fraction, CellInterval cell, INOUT(Radiance) radiance)
{
#if TETMARCH_LIGHT_ERROR
  radiance.lightError =
    radiance.lightError + radiance.transmittance * by.absorbed * fraction * lightErrorOf(cell);
#endif
#if TETMARCH_LIGHT_TOLERANCE
  // The front half of a dense subsegment hides the other half.
  middle = middle + fraction * (seenFraction(real(1), real(1) - by.absorbed) - real(0.5));
#endif
#if TETMARCH_LIT
  Illumination lit = illuminationWithin(cell, middle);
#if TETMARCH_SAMPLED_SHADOWS
  keepPending(radiance, mean, lit, by);
#endif
  absorb(radiance, litEmission(mean, lit, radiance, by), by);
#else
  absorb(radiance, emission(mean), by);
#endif
}
