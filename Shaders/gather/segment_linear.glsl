// Emission and absorption along one ray segment in which the scalar is linear.
//
// A piece of it is evaluated with its exact means of C tau and tau, as if colour and extinction were spread evenly in
// it (Engel, Kraus and Ertl 2001; gather/order_error.glsl bounds what that loses). The adaptive rule accepts a piece if its
// error, seen through what lies in front, fits the budget of the pixel: the tolerance is spread over what the ray
// absorbs, less what the pieces before have used. So a pixel keeps it however many cells it sees. What isn't accepted
// is tried again in shorter pieces.

#if TETMARCH_ERROR_BOUND && !TETMARCH_COMPONENTS
// Of a piece of the given optical depth between two points of the table.
real subsegmentError(TablePoint p, TablePoint q, real depth)
{
  return min(abs(q.variation - p.variation), real(1)) * orderErrorFactor(depth);
}
#endif

// From table position begin to end over a length in scalar opacity unit distances. `at` is the table at the
// last end, which is mostly this begin; where it isn't, the first trial only reads the table there. Returns
// the number of trials. The body stands at the end of one loop that mostly runs once: an `if` costs a
// software renderer as much as both its branches.
#if TETMARCH_EFFECTS && TETMARCH_DEPENDENT
int integrateSegment(real begin, real end, real thickness, vec3 furtherBegin, vec3 furtherEnd,
  CellShades shades, INOUT(TablePoint) at, INOUT(Radiance) radiance)
#elif TETMARCH_EFFECTS
int integrateSegment(real begin, real end, real thickness, CellShades shades, INOUT(TablePoint) at,
  INOUT(Radiance) radiance)
#elif TETMARCH_INDEPENDENT
int integrateSegment(vec4 begin, vec4 end, real thickness, INOUT(Radiance) radiance)
#elif TETMARCH_DEPENDENT
int integrateSegment(real begin, real end, real thickness, vec3 furtherBegin, vec3 furtherEnd,
  INOUT(TablePoint) at, INOUT(Radiance) radiance)
#else
int integrateSegment(
  real begin, real end, real thickness, INOUT(TablePoint) at, INOUT(Radiance) radiance)
#endif
{
#if TETMARCH_INDEPENDENT
  bool loaded = true;
#else
  bool loaded = at.x == begin;
#endif
  real position = real(0); // how far it is integrated, 0..1
  real step = real(1);     // the piece to try
  int trials = 0;
  bool pending = true;
  do
  {
    bool whole = !(position + step < real(1)); // also if it is NaN: the loop ends whatever the input
    real share = whole ? real(1) - position : step;
#if TETMARCH_INDEPENDENT
    vec4 target = whole ? end : begin + (end - begin) * (position + step);
    IndependentMean mixture = independentMeanBetween(begin + (end - begin) * position, target);
    vec4 mean = mixture.mean;
#else
    real target = whole ? end : begin + (end - begin) * (position + step);
    TablePoint next = tablePoint(loaded ? target : begin);
    vec4 mean = meanBetween(at, next);
#endif
#if TETMARCH_DEPENDENT
    vec3 furtherRise = furtherEnd - furtherBegin;
    DependentColor tint =
      dependentColorBetween(furtherBegin + furtherRise * position, furtherBegin + furtherRise * (position + share));
    mean = withDependentColor(mean, tint);
#endif
    real subsegmentThickness = loaded ? share * thickness : real(0);
#if TETMARCH_EFFECTS
    Shade shade = shadeWithin(shades, position + real(0.5) * share);
#endif
#if TETMARCH_GRADIENT_OPACITY
    subsegmentThickness = subsegmentThickness * shade.density;
#endif
    Absorption piece = absorption(mean, subsegmentThickness);
#if TETMARCH_ERROR_BOUND
#if TETMARCH_INDEPENDENT
    real error = radiance.transmittance * mixture.change * orderErrorFactor(piece.depth);
#elif TETMARCH_DEPENDENT
    real error = loaded ? radiance.transmittance * dependentError(tint, at, next, mean.w, piece) : real(0);
#else
    real error = loaded ? radiance.transmittance * subsegmentError(at, next, piece.depth) : real(0);
#endif
#if TETMARCH_LIT
    error = error * brightness(shade.lit);
#endif
#endif
#if TETMARCH_ADAPTIVE
    real budget = errorBudget(radiance, radiance.transmittance * piece.absorbed);
    bool accepted = error <= budget || trials >= mostTrials;
#else
    bool accepted = true;
#endif
    if (accepted)
    {
#if TETMARCH_LIGHT_ERROR
      radiance.lightError = radiance.lightError +
        radiance.transmittance * piece.absorbed * share * lightErrorOf(shades);
#endif
#if TETMARCH_SAMPLED_SHADOWS
      keepPending(radiance, mean, shade.lit, piece);
#endif
#if TETMARCH_LIT
      absorb(radiance, litEmission(mean, shade.lit, radiance, piece), piece);
#else
      absorb(radiance, emission(mean), piece);
#endif
#if TETMARCH_ERROR_BOUND
      radiance.error = radiance.error + error;
#endif
      pending = !(loaded && whole) && !isOpaque(radiance);
      position = loaded ? position + share : position;
      step = loaded ? real(2) * step : step;
#if !TETMARCH_INDEPENDENT
      at = next;
      loaded = true;
#endif
    }
#if TETMARCH_ADAPTIVE
    else
    {
      // The error grows with the third power of the step, what it earns with the first.
      step = share * clamp(real(0.9) * sqrt(budget / error), real(0.1), real(0.5));
    }
#endif
    trials = trials + 1;
  } while (pending);
  return trials;
}
