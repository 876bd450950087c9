// Along a ray the scalar of a trilinear cell is a cubic polynomial of the depth (Parker et al. 1998). With x from 0 to 1
// between two points of the ray it differs from the straight line between its ends by
//   -x (1 - x) (b + c (1 + x)),
// where b and c are the coefficients of x^2 and x^3: the bend.
real bentScalar(real begin, real end, vec2 bend, real x)
{
  return begin + (end - begin) * x - x * (real(1) - x) * (bend.x + bend.y * (real(1) + x));
}

// The bend of the part from x = from to x = to.
vec2 bendWithin(vec2 bend, real from, real to)
{
  real h = to - from;
  return vec2((bend.x + real(3) * bend.y * from) * h * h, bend.y * h * h * h);
}

#if TETMARCH_VARIATIONS || TETMARCH_EVEN_CUTS
// Upper bound of the cubic's distance from the straight line: x (1 - x) is at most a quarter, and b + c (1 + x) is
// between b + c and b + 2 c.
real greatestBend(vec2 bend)
{
  return real(0.25) * max(abs(bend.x + bend.y), abs(bend.x + real(2) * bend.y));
}

#endif

#if TETMARCH_VARIATIONS && !TETMARCH_EVEN_CUTS
// The maximum distance r between the position, 0..1, at which the scalar has a value, and that on the straight line.
real greatestShift(vec2 bend, real rise) { return min(greatestBend(bend) / max(abs(rise), real(1e-20)), real(1)); }
#endif

#if TETMARCH_SLOPE_VARIATION || TETMARCH_EVEN_CUTS
// The correction of the mean of a function of the scalar over the straight line, relative to its rise from end to end:
// for a function of constant slope the result is the mean along the cubic. rise: of the scalar.
real bentShare(vec2 bend, real rise)
{
  return -(bend.x / real(6) + bend.y / real(4)) / (rise < real(0) ? min(rise, -TINY) : max(rise, TINY));
}

#endif

#if TETMARCH_SLOPE_VARIATION
vec4 bentMean(vec4 mean, vec4 begin, vec4 end, vec2 bend, real rise)
{
  vec4 along = mean + (end - begin) * bentShare(bend, rise);
  return vec4(max(along.x, real(0)), max(along.y, real(0)), max(along.z, real(0)), max(along.w, real(0)));
}

// The error of the mean by bentMean() for a total variation of 1 of the function's slope per table entry.
//
// With u from 0 to 1 along the straight line and h(u) the shift of the position minus its mean, the error of the mean
// is the integral of h times the function's slope; by parts, with H the integral of h, which is 0 at both ends, it is
// at most the maximum of H times the variation of the slope. In the cubic's own x, with d(x) = x (1 - x) (b + c (1 +
// x)) / rise and m its mean, H is the integral of d minus m x, plus d (m - d / 2): the first is at most 0.0161 b +
// 0.0325 c over the rise, the second r^2 / 2 if d has one sign, and 3 r^2 / 2 if not.
real bentMeanError(vec2 bend, real rise)
{
  real perRise = real(1) / max(abs(rise), real(1e-20));
  real r = greatestShift(bend, rise);
  real second = (bend.x + bend.y) * (bend.x + real(2) * bend.y) < real(0) ? real(1.5) : real(0.5);
  real first = (real(0.0161) * abs(bend.x) + real(0.0325) * abs(bend.y)) * perRise;
  return abs(rise) * (first + second * r * r);
}
#endif

#if TETMARCH_ERROR_BOUND && !TETMARCH_INDEPENDENT && !TETMARCH_EVEN_CUTS
// The effect of the bend on the light of a subsegment in which the scalar is monotonic, and which is integrated as if
// its table positions were linear. bend and rise: in table positions. by: of the subsegment; colorVariation and
// extinctionVariation: the total variations of colour and extinction between its ends.
//
// Let g be the position, 0..1, at which the scalar has a value, and g0 that on the straight line: they differ by at
// most r = bend / rise. The optical depth up to a value is the thickness L times the integral of tau dg; integrated by
// parts its error is at most L r (tau + V), with V the variation of tau, and at the end L r V. Likewise dg is between 1
// / (1 + q) and 1 / (1 - q) times dg0 if the slope of the cubic is within q of that of the line, so that the relative
// error of optical depths is at most q / (1 - q). The colour is the integral of C over the opacity: by parts its error
// is at most that of the opacity times the variation of C.
real bendError(vec2 bend, real rise, Absorption by, real colorVariation, real extinctionVariation)
{
  real perRise = real(1) / max(abs(rise), real(1e-20));
  real r = greatestShift(bend, rise);
  real q = (abs(bend.x) + real(2) * abs(bend.y)) * perRise;
  real byShare = q < real(1) ? by.depth * q / (real(1) - q) : NO_DEPTH;
  real byVariation = by.thickness * r * extinctionVariation;
  real within = by.depth * r + real(2) * byVariation; // the minimum extinction is at most the mean
  return min(min(byVariation, byShare), real(1)) + min(colorVariation, real(1)) * min(min(within, byShare), real(1));
}
#endif
