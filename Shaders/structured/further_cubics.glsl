// The further scalars of several components along a ray in a trilinear cell: each has its own cubic. Each component of
// a vec3 belongs to one scalar.

// As the bend of the first scalar (structured/bend.glsl): the coefficients of x^2 and x^3.
struct FurtherBend
{
  vec3 square;
  vec3 cube;
};

vec3 bentScalars(vec3 begin, vec3 end, FurtherBend bend, real x)
{
  return begin + (end - begin) * x - (bend.square + bend.cube * (real(1) + x)) * (x * (real(1) - x));
}

// The bend of the part from x = from to x = to.
FurtherBend furtherBendWithin(FurtherBend bend, real from, real to)
{
  real h = to - from;
  FurtherBend within;
  within.square = (bend.square + bend.cube * (real(3) * from)) * (h * h);
  within.cube = bend.cube * (h * h * h);
  return within;
}

struct FurtherCubics
{
  vec3 value; // at the ray's entry into the cell
  vec3 slope; // the coefficients of x
  FurtherBend bend;
#if !TETMARCH_DIRECT_COLOR
  vec3 firstExtremes; // between 0 and 1; NO_EXTREME where there is none
  vec3 secondExtremes;
#endif
};

FurtherCubics noFurtherCubics()
{
  FurtherCubics none;
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

vec3 furtherCubicsAt(FurtherCubics further, real x)
{
  return further.value + (further.slope + (further.bend.square + further.bend.cube * x) * x) * x;
}

// The scalars of a direct colour, which have no tables, may have extremes inside a part of the cell.
FurtherCubics furtherCubicsAlong(Ray ray, ivec3 cell, real enter, real leave)
{
  FurtherCubics further = noFurtherCubics();
  vec4 a = cubicOfComponent(1, ray, cell, enter, leave);
#if TETMARCH_COLOR_AND_OPACITY
  further.value.x = a.x;
  further.slope.x = a.y;
  further.bend.square.x = a.z;
  further.bend.cube.x = a.w;
  vec2 extremes = extremesOf(a);
  further.firstExtremes.x = extremes.x;
  further.secondExtremes.x = extremes.y;
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
  further.firstExtremes = vec3(ofA.x, ofB.x, ofC.x);
  further.secondExtremes = vec3(ofA.y, ofB.y, ofC.y);
#else
  vec4 b = cubicOfComponent(2, ray, cell, enter, leave);
  vec4 c = cubicOfComponent(3, ray, cell, enter, leave);
#endif
  further.value = vec3(a.x, b.x, c.x);
  further.slope = vec3(a.y, b.y, c.y);
  further.bend.square = vec3(a.z, b.z, c.z);
  further.bend.cube = vec3(a.w, b.w, c.w);
#endif
  return further;
}

#if !TETMARCH_DIRECT_COLOR
// The next of two extremes after x; NO_EXTREME if there is none.
real nextOf(real first, real second, real x) { return first > x ? first : (second > x ? second : NO_EXTREME); }

real nextFurtherExtreme(FurtherCubics further, real x)
{
  real a = nextOf(further.firstExtremes.x, further.secondExtremes.x, x);
  real b = nextOf(further.firstExtremes.y, further.secondExtremes.y, x);
  real c = nextOf(further.firstExtremes.z, further.secondExtremes.z, x);
  return min(a, min(b, c));
}
#endif
