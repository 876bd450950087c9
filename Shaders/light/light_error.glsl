// How far off light may be: for changing along a piece of a ray, of which the mean of both ends is taken, and for being
// interpolated between vertices.
real changeOf(Light p, Light q) { return greatest(q.diffuse - p.diffuse) + greatest(q.specular - p.specular); }

// In a tetrahedron. The mean of two ends is off by at most half of their difference from what is between them, as far as
// light changes one way only. Lights are taken for as bright as white surfaces are.
real lightErrorOf(CellShades shades)
{
  Illumination p = shades.enter.lit;
  Illumination q = shades.leave.lit;
  real change = changeOf(p.direct, q.direct);
#if TETMARCH_HEADLIGHT_SHADOWS
  change = change + changeOf(p.head, q.head);
#endif
#if TETMARCH_SAMPLED_SHADOWS
  change = change + changeOf(p.beamA, q.beamA);
#if TETMARCH_SEVERAL_SHADOWS
  change = change + changeOf(p.beamB, q.beamB) + changeOf(p.beamC, q.beamC);
#endif
#endif
  real error = real(0.5) * change * (shades.within.y - shades.within.x);
#if TETMARCH_VERTEX_LIGHT
  error = error + shades.unsure;
#endif
  return error;
}
