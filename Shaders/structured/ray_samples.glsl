// The points of a ray at which the volume is looked up, at even distances, where it is sampled instead of integrated
// (gather/segment_sampled.glsl).

// Samples are nearer to the eye than they should be by this share of a step: rounding would else decide whether one on the
// last plane of the volume counts, and to which of two cells one on the plane between them belongs.
CONSTANT real SAMPLE_SHIFT = real(0.0001);

// Samples begin where the ray enters the lattice, or where it begins inside of it; before shiftSamples().
void placeSamples(real depthBegin, INOUT(Ray) ray) { ray.firstSample = max(depthsOfLattice(ray).x, depthBegin); }

// The first sample lies that far behind, in steps: one, or less with jitter. Without jitter a ray takes one sample at
// least, as in VTK: where that would lie behind the lattice, it is the last point of the ray. With jitter that would add
// to what rays see on the average.
void shiftSamples(real steps, INOUT(Ray) ray)
{
  real first = ray.firstSample + (steps - SAMPLE_SHIFT) * sampleStep;
  real last = depthsOfLattice(ray).y - SAMPLE_SHIFT * sampleStep;
  ray.firstSample = steps < real(1) ? first : min(first, last);
}

// Depths, as floats, tell no more samples apart: 2^24.
CONSTANT real MOST_SAMPLES = real(16777216);

// How many samples lie in front of a depth. The same depth has the same number, whatever cell asks for it: so no sample
// counts twice, and none is left out.
int samplesBefore(Ray ray, real depth)
{
  return int(max(real(0), min(floor((depth - ray.firstSample) * samplesPerDepth) + real(1), MOST_SAMPLES)));
}

#if TETMARCH_POINT_SCALARS || TETMARCH_EFFECTS
real depthOfSample(Ray ray, int k) { return ray.firstSample + real(k) * sampleStep; }
#endif
