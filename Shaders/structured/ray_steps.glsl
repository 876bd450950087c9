// The steps of a ray through a lattice.

int stepAlong(real slope) { return abs(slope) > TINY ? (slope > real(0) ? 1 : -1) : 0; }
real neverAlong(real slope) { return abs(slope) > TINY ? real(0) : real(1); }
real perSlopeOf(real slope) { return abs(slope) > TINY ? real(1) / slope : real(0); }

// Set by its origin and direction.
void orient(INOUT(Ray) ray)
{
  ray.start = toLattice(ray.origin);
  ray.slope = directionToLattice(ray.direction);
  ray.perSlope = vec3(perSlopeOf(ray.slope.x), perSlopeOf(ray.slope.y), perSlopeOf(ray.slope.z));
  ray.never = vec3(neverAlong(ray.slope.x), neverAlong(ray.slope.y), neverAlong(ray.slope.z));
  ray.steps = ivec3(stepAlong(ray.slope.x), stepAlong(ray.slope.y), stepAlong(ray.slope.z));
#if TETMARCH_POINT_SAMPLED
  ray.firstSample = NO_DEPTH; // until placeSamples()
#endif
}
