// How far light that changes along a piece of a ray may be from the mean of its ends.
real changeOf(Light p, Light q) { return greatest(q.diffuse - p.diffuse) + greatest(q.specular - p.specular); }

// The mean of two ends is off by at most half of their difference from what is between them, as far as light changes
// one way only.
real lightErrorOf(CellShades shades)
{
  Illumination p = shades.enter.lit;
  Illumination q = shades.leave.lit;
  real change = changeOf(p.direct, q.direct);
#if TETMARCH_HEADLIGHT_SHADOWS
  change = change + changeOf(p.head, q.head);
#endif
#if TETMARCH_SAMPLED_SHADOWS
  change = change + changeOf(p.beam[0], q.beam[0]) + changeOf(p.beam[1], q.beam[1]) + changeOf(p.beam[2], q.beam[2]);
#endif
  return real(0.5) * change * (shades.within.y - shades.within.x);
}
