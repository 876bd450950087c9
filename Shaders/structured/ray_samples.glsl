// The points of a ray, at even distances, at which a sampled volume is evaluated (gather/segment_sampled.glsl).

// Samples are moved towards the eye by this share of a step: otherwise rounding would decide whether a sample on the
// last plane of the volume counts, and to which of two cells one on the plane between them belongs.
CONSTANT real SAMPLE_SHIFT = real(0.0001);

// Samples begin at the ray's entry into the lattice, or at its begin inside; before shiftSamples().
void placeSamples(real depthBegin, INOUT(Ray) ray) { ray.firstSample = max(depthsOfLattice(ray).x, depthBegin); }

// Moves the first sample by this number of steps: one, or less with jitter. Without jitter a ray has at least one
// sample, as in VTK: if it would be behind the lattice, it is the last point of the ray. With jitter this would bias
// the average.
void shiftSamples(real steps, INOUT(Ray) ray)
{
  real first = ray.firstSample + (steps - SAMPLE_SHIFT) * sampleStep;
  real last = depthsOfLattice(ray).y - SAMPLE_SHIFT * sampleStep;
  ray.firstSample = steps < real(1) ? first : min(first, last);
}

// Maximum number of samples distinguishable by float depths: 2^24.
CONSTANT real MOST_SAMPLES = real(16777216);

// The number of samples in front of a depth. It depends on the depth only, not on the cell: so no sample counts twice,
// and none is left out.
int samplesBefore(Ray ray, real depth)
{
  return int(max(real(0), min(floor((depth - ray.firstSample) * samplesPerDepth) + real(1), MOST_SAMPLES)));
}

#if TETMARCH_POINT_SCALARS || TETMARCH_EFFECTS
real depthOfSample(Ray ray, int k) { return ray.firstSample + real(k) * sampleStep; }
#endif
