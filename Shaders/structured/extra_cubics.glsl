// The extra scalars of several components along a ray in a trilinear cell: each has its own cubic. Each component of
// a vec3 belongs to one scalar.

// As the bend of the first scalar (structured/bend.glsl): the coefficients of x^2 and x^3.
struct ExtraBend
{
  vec3 square;
  vec3 cube;
};

vec3 bentScalars(vec3 begin, vec3 end, ExtraBend bend, real x)
{
  return begin + (end - begin) * x - (bend.square + bend.cube * (real(1) + x)) * (x * (real(1) - x));
}

// The bend of the part from x = from to x = to.
ExtraBend extraBendWithin(ExtraBend bend, real from, real to)
{
  real h = to - from;
  ExtraBend within;
  within.square = (bend.square + bend.cube * (real(3) * from)) * (h * h);
  within.cube = bend.cube * (h * h * h);
  return within;
}

struct ExtraCubics
{
  vec3 value; // at the ray's entry into the cell
  vec3 slope; // the coefficients of x
  ExtraBend bend;
#if !TETMARCH_DIRECT_COLOR
  vec3 firstExtremes; // between 0 and 1; NO_EXTREME where there is none
  vec3 secondExtremes;
#endif
};

ExtraCubics noExtraCubics()
{
  ExtraCubics none;
  none.value = vec3(real(0), real(0), real(0));
  none.slope = none.value;
  none.bend.square = none.value;
  none.bend.cube = none.value;
#if !TETMARCH_DIRECT_COLOR
  none.firstExtremes = vec3(NO_EXTREME, NO_EXTREME, NO_EXTREME);
  none.secondExtremes = none.firstExtremes;
#endif
  return none;
}

vec3 extraCubicsAt(ExtraCubics extra, real x)
{
  return extra.value + (extra.slope + (extra.bend.square + extra.bend.cube * x) * x) * x;
}

// The scalars of a direct colour, which have no tables, may have extremes inside a part of the cell.
ExtraCubics extraCubicsAlong(Ray ray, ivec3 cell, real enter, real leave)
{
  ExtraCubics extra = noExtraCubics();
  vec4 a = cubicOfComponent(1, ray, cell, enter, leave);
#if TETMARCH_COLOR_AND_OPACITY
  extra.value.x = a.x;
  extra.slope.x = a.y;
  extra.bend.square.x = a.z;
  extra.bend.cube.x = a.w;
  vec2 extremes = extremesOf(a);
  extra.firstExtremes.x = extremes.x;
  extra.secondExtremes.x = extremes.y;
#else
#if TETMARCH_INDEPENDENT
  vec4 b = vec4(real(0), real(0), real(0), real(0));
  vec4 c = b;
  if (componentCount > 2)
  {
    b = cubicOfComponent(2, ray, cell, enter, leave);
  }
  if (componentCount > 3)
  {
    c = cubicOfComponent(3, ray, cell, enter, leave);
  }
  vec2 ofA = extremesOf(a);
  vec2 ofB = extremesOf(b);
  vec2 ofC = extremesOf(c);
  extra.firstExtremes = vec3(ofA.x, ofB.x, ofC.x);
  extra.secondExtremes = vec3(ofA.y, ofB.y, ofC.y);
#else
  vec4 b = cubicOfComponent(2, ray, cell, enter, leave);
  vec4 c = cubicOfComponent(3, ray, cell, enter, leave);
#endif
  extra.value = vec3(a.x, b.x, c.x);
  extra.slope = vec3(a.y, b.y, c.y);
  extra.bend.square = vec3(a.z, b.z, c.z);
  extra.bend.cube = vec3(a.w, b.w, c.w);
#endif
  return extra;
}

#if !TETMARCH_DIRECT_COLOR
// The next of two extremes after x; NO_EXTREME if there is none.
real nextOf(real first, real second, real x) { return first > x ? first : (second > x ? second : NO_EXTREME); }

real nextExtraExtreme(ExtraCubics extra, real x)
{
  real a = nextOf(extra.firstExtremes.x, extra.secondExtremes.x, x);
  real b = nextOf(extra.firstExtremes.y, extra.secondExtremes.y, x);
  real c = nextOf(extra.firstExtremes.z, extra.secondExtremes.z, x);
  return min(a, min(b, c));
}
#endif
