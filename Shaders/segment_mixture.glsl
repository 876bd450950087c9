// Emission and absorption of independent components.
#if TETMARCH_POINT_SCALARS
// Along a ray segment in which their scalars are linear; as segment_linear.glsl does with one, but that what is lost of the
// order of colours is bounded by their range in the piece (order_error.glsl). Returns the number of trials.
int integrateMixture(vec4 begin, vec4 end, real opticalLength, INOUT(Radiance) radiance)
{
  real position = real(0); // how far it is integrated, 0..1
  real step = real(1);     // the piece to try
  int trials = 0;
  bool pending = true;
  do
  {
    bool whole = !(position + step < real(1)); // also if it is NaN: the loop ends whatever the input
    real share = whole ? real(1) - position : step;
    vec4 from = begin + (end - begin) * position;
    vec4 to = whole ? end : begin + (end - begin) * (position + step);
    Mixture mixture = mixtureBetween(from, to);
    Absorption piece = absorption(mixture.mean, share * opticalLength);
#if TETMARCH_ERROR_BOUND
    real error = radiance.transmittance * mixture.change * orderErrorFactor(piece.depth);
#endif
#if TETMARCH_ADAPTIVE
    real budget = errorBudget(radiance, radiance.transmittance * piece.absorbed);
    bool accepted = error <= budget || trials >= mostTrials;
#else
    bool accepted = true;
#endif
    if (accepted)
    {
      absorb(radiance, emission(mixture.mean), piece);
#if TETMARCH_ERROR_BOUND
      radiance.error = radiance.error + error;
#endif
      pending = !whole && !isOpaque(radiance);
      position = position + share;
      step = real(2) * step;
    }
#if TETMARCH_ADAPTIVE
    else
    {
      step = share * clamp(real(0.9) * sqrt(budget / error), real(0.1), real(0.5));
    }
#endif
    trials = trials + 1;
  } while (pending);
  return trials;
}
#else
// Where their scalars are constant, it is exact.
void absorbMixture(vec4 scalars, real opticalLength, INOUT(Radiance) radiance)
{
  vec4 mean = mixtureAt(scalars);
  absorb(radiance, emission(mean), absorption(mean, opticalLength));
}
#endif
