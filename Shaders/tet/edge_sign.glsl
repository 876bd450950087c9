// The predicate that makes the traversal watertight: the direction in which two projected vertices turn around the ray.
//
// The sign is that of the exact cross product of the given bits, the same for every caller, with ties broken as by one
// infinitesimal perturbation (Edelsbrunner and Muecke, "Simulation of Simplicity", 1990): the ray is shifted by
// (-e^2, -e), and then each vertex is rotated around it by e^3 times its index. Then a ray crosses 0 or 2 faces of a
// tetrahedron, and cannot get lost. The indices matter only if two vertices are projected to the same point.

// Projected coordinates are multiplied by PROJECTION_SCALE, and those nearer to 0 than PROJECTION_FLUSH become 0, so that
// no product below leaves the range of normal numbers, even if denormal numbers are flushed to 0.
vec2 snapToPredicate(vec2 p)
{
#if TETMARCH_HAS_FMA
  precise real x = p.x * PROJECTION_SCALE;
  precise real y = p.y * PROJECTION_SCALE;
  return vec2(abs(x) < PROJECTION_FLUSH ? real(0) : x, abs(y) < PROJECTION_FLUSH ? real(0) : y);
#else
  // Integers below 2^24 in magnitude: a bounding radius is 2^22.
  precise real x = p.x * real(4194304.0) + real(0.5);
  precise real y = p.y * real(4194304.0) + real(0.5);
  return vec2(floor(x), floor(y));
#endif
}

// 2^-20 mesh radii as projected: upper bound of the displacement of a vertex by rounding.
real projectionBlur()
{
#if TETMARCH_HAS_FMA
  return PROJECTION_SCALE * real(9.5367431640625e-7);
#else
  return real(4);
#endif
}

// p.x q.y - q.x p.y, with the sign of the exact value: 0 only for an exact tie.
real edgeCross(vec2 p, vec2 q)
{
#if TETMARCH_HAS_FMA
  // Kahan's difference of products (Jeannerod, Louvet and Muller 2013): within 1.5 ulp.
  precise real w = q.x * p.y;
  precise real e = fma(-q.x, p.y, w);
  precise real d = fma(p.x, q.y, -w);
  precise real c = d + e;
  return c;
#else
  // The wrapped integer difference is exact up to a multiple of 2^32, which follows from the difference of the rounded
  // products: with coordinates below 2^24 its error is less than 2^26. The value is within 1 ulp.
  int wrapped = int(uint(int(p.x)) * uint(int(q.y)) - uint(int(q.x)) * uint(int(p.y)));
  precise real rounded = p.x * q.y - q.x * p.y;
  precise real turns = floor((rounded - real(wrapped)) * real(2.3283064365386962890625e-10) + real(0.5));
  precise real c = real(wrapped) + turns * real(4294967296.0);
  return c;
#endif
}

// Whether vertex i at p, then vertex j at q turn counter-clockwise around the ray; c is edgeCross(p, q).
bool turnsLeft(real c, vec2 p, uint i, vec2 q, uint j)
{
  vec2 d = vec2(q.x - p.x, q.y - p.y);
  real turn = c != real(0) ? c : (d.x != real(0) ? -d.x : d.y);
  return turn > real(0) || (turn == real(0) && i < j);
}
