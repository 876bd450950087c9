// What is lost because integrals are whole numbers of steps (tables/integral_table.glsl).
//
// Each is at most half a step from what it should be, so that a mean of C tau or tau is at most a step off for each bin
// over which it is taken. An error t of tau and k of C tau changes the optical depth along a thickness L by t L. What is seen of the piece and
// of all behind it changes by no more than that, and what the piece emits by k L besides. As C is at most 1, no step of C
// tau is greater than that of tau. Steps of colours that have a table of their own are below the rounding of a float.

#if TETMARCH_EVEN_CUTS
// 1 / the number of bins over which a mean is taken, or 0 if it is taken from values alone.
real perBinsBetween(IntegralPoint p, IntegralPoint q)
{
  real bins = abs(q.x - p.x);
  return bins < LEAST_RISE ? real(0) : real(1) / bins;
}
#elif !TETMARCH_INDEPENDENT
real perBinsBetween(TablePoint p, TablePoint q)
{
  return abs(q.bin - p.bin) <= 1 ? real(0) : real(1) / abs(q.x - p.x);
}
#endif

// No channel is off by more for each unit of thickness whose means are taken over one bin, seen through a transmittance
// of 1.
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
