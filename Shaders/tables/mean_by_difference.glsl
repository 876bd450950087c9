// Means over an interval of scalars as difference quotients of the integrals: half the reads of integral_table.glsl,
// for functions that are constant in each bin.

// One end of an interval.
struct IntegralPoint
{
  real x;
  uvec4 integral; // K, T at the entry below x
  vec4 rise;      // of K, T in the bin of x: C tau and tau, in the units of the table
  vec4 part;      // of that up to x
};

IntegralPoint integralPoint(real x)
{
  IntegralPoint p;
  int bin = tableBin(x);
  p.x = x;
  p.integral = fetchTableIntegral(bin);
  p.rise = vec4(fetchTableIntegral(bin + 1) - p.integral);
  p.part = p.rise * (x - real(bin));
  return p;
}

// Shorter intervals are in one bin, or so short that the integrals' steps would be significant in a quotient.
CONSTANT real LEAST_RISE = real(0.05);

vec4 meanByDifference(IntegralPoint p, IntegralPoint q)
{
  real rise = q.x - p.x;
  bool narrow = abs(rise) < LEAST_RISE;
  real perRise = real(1) / (narrow ? real(1) : rise);
  vec4 entries = vec4(rise < real(0) ? p.integral - q.integral : q.integral - p.integral);
  vec4 mean = entries * abs(perRise) + (q.part - p.part) * perRise;
  return (narrow ? q.rise : mean) * tableIntegralUnit;
}
