// A part of a segment that is integrated at once.

#if TETMARCH_POINT_SCALARS && !TETMARCH_POINT_SAMPLED && !TETMARCH_EVEN_CUTS
struct Subsegment
{
  real begin;    // where in the segment, 0..1
  real end;
  real fraction; // of the segment
  real pieces;   // as large as this one into which the segment is cut from here on
  bool last;     // it reaches the end
};

// The first of so many equal pieces of what is left of the segment.
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

// A thickness times the factor that gradients give the extinction at a fraction of the segment.
real thicknessWithin(CellInterval cell, real fraction, real thickness)
{
#if TETMARCH_GRADIENT_OPACITY
  return thickness * densityWithin(cell.shades, fraction);
#else
  return thickness;
#endif
}

#if TETMARCH_TABLE_ERROR
// Notes that a mean was looked up over a number of bins.
void addLookup(real perBins, Absorption by, real middle, CellInterval cell, INOUT(Radiance) radiance)
{
  real seen = radiance.transmittance * by.thickness * perBins;
#if TETMARCH_LIT
  // What is behind and what is reflected as from white surfaces is taken for no brighter than 1.
  seen = seen * (real(1) + brightness(illuminationWithin(cell.shades, middle)));
#endif
  radiance.lookedUp = radiance.lookedUp + seen;
}
#endif

// Adds a subsegment to what the ray has gathered. mean: of C tau and tau; middle: where in the segment the middle of the
// subsegment lies; fraction: how much of the segment it is.
void addSubsegment(
  vec4 mean, Absorption by, real middle, real fraction, CellInterval cell, INOUT(Radiance) radiance)
{
#if TETMARCH_LIGHT_ERROR
  radiance.lightError =
    radiance.lightError + radiance.transmittance * by.absorbed * fraction * lightErrorOf(cell.shades);
#endif
#if TETMARCH_LIT
  Illumination lit = illuminationWithin(cell.shades, middle);
#if TETMARCH_SAMPLED_SHADOWS
  keepPending(radiance, mean, lit, by);
#endif
  absorb(radiance, litEmission(mean, lit, radiance, by), by);
#else
  absorb(radiance, emission(mean), by);
#endif
}
