// The scalar along a ray in a trilinear cell.

struct CellFrame
{
  vec3 begin;    // its lower corner, in lattice coordinates
  vec3 perWidth; // reciprocal of its sides
};

CellFrame cellFrame(ivec3 cell)
{
  CellFrame frame;
#if TETMARCH_RECTILINEAR
  frame.begin = planesAt(cell);
  vec3 width = planesAt(ivec3(cell.x + 1, cell.y + 1, cell.z + 1)) - frame.begin;
  frame.perWidth = vec3(real(1) / width.x, real(1) / width.y, real(1) / width.z);
#else
  // Half cells at the end of an axis have the same value at both ends.
  frame.begin = vec3(real(cell.x) + latticeShift.x, real(cell.y) + latticeShift.y, real(cell.z) + latticeShift.z);
  frame.perWidth = vec3(real(1), real(1), real(1));
#endif
  return frame;
}

// As a polynomial of x = 0..1 between two depths: the coefficients of 1, x, x^2, x^3. The first one is UNDRAWN_SCALAR
// if a value of the cell is not finite.
#if TETMARCH_COMPONENTS
vec4 cubicOfComponent(int component, Ray ray, ivec3 cell, real enter, real leave)
#else
vec4 cubicAlong(Ray ray, ivec3 cell, real enter, real leave)
#endif
{
  int i = cell.x + firstValue.x;
  int j = cell.y + firstValue.y;
  int k = cell.z + firstValue.z;
#if TETMARCH_COMPONENTS
  vec4 low = fetchValuesOf(component, i, j, k);
  vec4 high = fetchValuesOf(component, i, j, k + 1);
#else
  vec4 low = fetchValues(i, j, k);
  vec4 high = fetchValues(i, j, k + 1);
#endif
  CellFrame frame = cellFrame(cell);
  vec3 a = (ray.start + ray.slope * enter - frame.begin) * frame.perWidth;
  vec3 e = ray.slope * frame.perWidth * (leave - enter);
  // f(x, y, z) = f0 + fx x + fy y + fz z + fxy x y + fxz x z + fyz y z + fxyz x y z
  real f0 = low.w;
  real fx = low.z - low.w;
  real fy = low.x - low.w;
  real fz = high.w - low.w;
  real lowXY = low.y - low.x - fx;
  real fxz = high.z - high.w - fx;
  real fyz = high.x - high.w - fy;
  real fxyz = high.y - high.x - (high.z - high.w) - lowXY;
  // Along y and z the cell's value and its change along x are bilinear.
  vec4 cubic;
  real value = f0 + fy * a.y + fz * a.z + fyz * a.y * a.z;
  real slope = fx + lowXY * a.y + fxz * a.z + fxyz * a.y * a.z;
  real valueRise = fy * e.y + fz * e.z + fyz * (a.y * e.z + a.z * e.y);
  real slopeRise = lowXY * e.y + fxz * e.z + fxyz * (a.y * e.z + a.z * e.y);
  real valueBend = fyz * e.y * e.z;
  real slopeBend = fxyz * e.y * e.z;
  cubic.x = value + slope * a.x;
  cubic.y = valueRise + slopeRise * a.x + slope * e.x;
  cubic.z = valueBend + slopeBend * a.x + slopeRise * e.x;
  cubic.w = slopeBend * e.x;
  // In a sum, one that isn't finite outweighs all others.
  vec4 sums = low + high;
  cubic.x = isDrawn(real(0.125) * ((sums.x + sums.y) + (sums.z + sums.w))) ? cubic.x : UNDRAWN_SCALAR;
  return cubic;
}

#if TETMARCH_COMPONENTS
// The cubic of the first scalar.
vec4 cubicAlong(Ray ray, ivec3 cell, real enter, real leave) { return cubicOfComponent(0, ray, cell, enter, leave); }
#endif

real cubicAt(vec4 cubic, real x) { return cubic.x + x * (cubic.y + x * (cubic.z + x * cubic.w)); }

#if TETMARCH_CELL_PARTS
CONSTANT real NO_EXTREME = real(2);

// The positions of the cubic's extremes between 0 and 1, in ascending order; NO_EXTREME if there is none, or no scalar.
// They are the roots of the derivative, without cancellation.
vec2 extremesOf(vec4 cubic)
{
  real a = real(3) * cubic.w;
  real b = cubic.z;
  real c = cubic.y;
  real d = isDrawn(cubic.x) ? b * b - a * c : real(0);
  real root = sqrt(max(d, real(0)));
  real q = -(b + (b < real(0) ? -root : root));
  real first = q / a;
  real second = c / q;
  // If d is 0 they may be NaN.
  first = d > real(0) && first > real(0) && first < real(1) ? first : NO_EXTREME;
  second = d > real(0) && second > real(0) && second < real(1) ? second : NO_EXTREME;
  return vec2(min(first, second), max(first, second));
}
#endif
