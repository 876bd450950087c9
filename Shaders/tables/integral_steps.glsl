// What is lost because integrals are whole numbers of steps (tables/integral_table.glsl).
//
// Each is at most half a step from what it should be, so that means of C tau and tau over a bin or more are at most a step
// off. An error t of tau and k of C tau changes the optical depth along a thickness L by t L. What is seen of the piece and
// of all behind it changes by no more than that, and what the piece emits by k L besides. As C is at most 1, no step of C
// tau is greater than that of tau. Steps of colours that have a table of their own are below the rounding of a float.

// No channel is off by more for each unit of thickness that is seen through a transmittance of 1.
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
#elif TETMARCH_EVEN_CUTS
  real step = tableIntegralUnit.w / LEAST_RISE; // means are taken over less than a bin
#else
  real step = tableIntegralUnit.w;
#endif
  return real(2) * step;
}
