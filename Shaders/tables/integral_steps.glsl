// The error of integrals that are whole numbers of steps (tables/integral_table.glsl).
//
// The error of each is at most half a step, so that the error of a mean of C tau or tau is at most one step per bin of
// its interval. An error t of tau and k of C tau changes the optical depth along a thickness L by t L. The visible
// light of the piece and of everything behind changes by at most that, and the emission of the piece additionally by k
// L. As C is at most 1, the step of C tau is at most that of tau. Steps of colours with their own table are below the
// rounding of a float.

#if TETMARCH_EVEN_CUTS
// 1 / the number of bins of a mean, or 0 if the mean is computed from values only.
real perBinsBetween(IntegralPoint p, IntegralPoint q)
{
  real bins = abs(q.x - p.x);
  return bins < LEAST_RISE ? real(0) : real(1) / bins;
}
#endif

// Error bound of each channel per unit of thickness with means over one bin and a transmittance of 1.
real errorOfSteps()
{
#if TETMARCH_INDEPENDENT
  real step = real(0);
  for (int k = 0; k < componentCount; ++k)
  {
    vec4 f = componentFactor;
    step = step + tableSpan(k).integralUnit.w * (k == 0 ? f.x : (k == 1 ? f.y : (k == 2 ? f.z : f.w)));
  }
#elif TETMARCH_DEPENDENT
  real step = tableSpan(0).integralUnit.w;
#else
  real step = tableIntegralUnit.w;
#endif
  return real(2) * step;
}
