// The effect of the bends of several scalars on the light of a subsegment, which is integrated as if the positions in
// all tables were linear from its begin to its end. Segments end at the extremes of each scalar with a table, so that
// each of these is monotonic in a subsegment.
//
// Let s(x), x = 0..1, be the cubic of a scalar and s0(x) the straight line between its ends, and let g(v) and g0(v) be
// the positions at which they have the value v. As in structured/bend.glsl g and g0 differ by at most r = bend / rise.
// Then for any function f with the total variation V between the ends, and any x,
//   |integral from 0 to x of f(s) - f(s0)| <= r V.                                                                  (1)
// By parts the integral of f(s) up to x is f(s(x)) x minus that of g df up to s(x), and likewise for s0; of s(x) and
// s0(x) let s(x) be the farther one. The difference is the integral of (g0 - g) df up to s0(x), and from there to s(x)
// that of (x - g) df, where g(v) <= x <= g0(v). Both factors are at most r.
//
// Below, u is the optical depth from the front, D all of it, A = 1 - exp(-D), L the thickness; those with 0 are by the
// straight lines. Light from behind, B, is part of what is seen, so that errors of D need no account of their own. B and
// colours C lie in 0..1.

#if TETMARCH_INDEPENDENT
// Independent components: with e = sum(tau_k C_k) the picture is the integral of L e exp(-u), plus B exp(-D). It is off by
//   integral of L (e - e0) exp(-u)  +  integral of L e0 (exp(-u) - exp(-u0)) + B (exp(-D) - exp(-D0)).
// exp(-u) falls from 1, so that by parts and by (1) the first term is at most L sum(r_k variation of tau_k C_k). By (1)
// u is off by W = L sum(r_k variation of tau_k) at most, everywhere, so that in the second and third the exponential is
// off by a share exp(W) - 1; and what they are shares of adds up to the picture of the straight lines, which is 1 at
// most. exp(W) - 1 <= W (1 + W) as long as W <= 1; beyond that the first term is above 1, and no picture is off by more.

// Per unit of thickness.
struct IndependentBend
{
  real emission;   // sum(r_k variation of tau_k C_k)
  real extinction; // sum(r_k variation of tau_k)
};

IndependentBend noBend()
{
  IndependentBend bent;
  bent.emission = real(0);
  bent.extinction = real(0);
  return bent;
}

// Of a component in an interval of its table. A function that goes from p to q with the total variation V stays
// within V / 2 of (p + q) / 2. The extinctions are multiplied by the factor.
void addBend(IntervalMean over, real ratio, real factor, INOUT(IndependentBend) bent)
{
  real variation = over.extinctionVariation;
  real most = (over.ends.w + variation) * real(0.5);
  real colorVariation = min(over.variation, real(1));
  bent.extinction = bent.extinction + factor * ratio * variation;
  bent.emission = bent.emission + factor * ratio * (variation + most * colorVariation);
}

real independentBend(IndependentBend bent, Absorption by)
{
  real exponent = bent.extinction * by.thickness;
  return bent.emission * by.thickness + exponent * (real(1) + exponent);
}
#else
// Dependent components: with the opacity a = 1 - exp(-u) the picture is the integral of C da, plus B (1 - A). By the
// straight lines of both scalars it is off by
//   integral of (C - C0) da  +  integral of C0 d(a - a0) - B (A - A0).
// By parts the second term is at most |A - A0|, which is bounded as that of one scalar is (bendError), plus the variation
// of C times the most that a is off by, which is L r variation of tau by (1).
// For the first one, let G(x) be the integral of C - C0 up to x, r' times the variation of C at most, with r' that of the
// colour's scalar. By parts it is at most max|G| times a'(1) + variation of a', with a' = L tau exp(-u). Let V be the
// variation of tau. tau is at most m + V, with m its mean by the straight line, which has the same values; the variation
// of a' is at most L V + L (m + V) A: together 2 (L m) + 3 L V.
// With direct colours C is no function of a table: the first term is 0, since the mean of the cubics is taken, and what
// the order of colours loses goes by the total variation of the cubics (bentVariation).
// Both pictures have means of the same colours: all that depends on the variation of C is that variation times A0 at most.

struct DependentBend
{
  real opacity;  // |A - A0|
  real light;    // of a, times the variation of the colour
  real perRatio; // times r' and the variation of the colour
};

// bend and rise: of the opacity's scalar, in table positions. extinctionVariation: of tau between the ends.
DependentBend dependentBend(vec2 bend, real rise, Absorption by, real extinctionVariation)
{
  real variation = by.thickness * extinctionVariation;
  DependentBend bent;
  bent.opacity = bendError(bend, rise, by, real(0), extinctionVariation);
  bent.light = greatestShift(bend, rise) * variation;
  bent.perRatio = real(2) * by.depth + real(3) * variation;
  return bent;
}

#if TETMARCH_DIRECT_COLOR
// The total variation of a cubic is at most the sum of those of the straight line and of their difference: that of
// x (1 - x) is 1/2, that of x (1 - x) (1 + x) is 4 / (3 sqrt(3)).
real bentVariation(real rise, real square, real cube)
{
  return abs(rise) + real(0.5) * abs(square) + real(0.77) * abs(cube);
}
#endif
#endif
