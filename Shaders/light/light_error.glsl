// Error bounds of light: by its change along a segment, for which the mean of both ends is used, and by interpolation
// between vertices.
real changeOf(Light p, Light q) { return greatest(q.diffuse - p.diffuse) + greatest(q.specular - p.specular); }

// Surfaces are assumed white, so that the change of light is that of their reflection.
real changeOfLight(Illumination p, Illumination q)
{
  real change = changeOf(p.direct, q.direct);
#if TETMARCH_HEADLIGHT_SHADOWS
  change = change + changeOf(p.head, q.head);
#endif
#if TETMARCH_SAMPLED_BEAMS
  change = change + changeOf(p.beamA, q.beamA);
#if TETMARCH_SEVERAL_SHADOWS
  change = change + changeOf(p.beamB, q.beamB) + changeOf(p.beamC, q.beamC);
#endif
#endif
  return change;
}

#if TETMARCH_LIGHT_ERROR
// In a tetrahedron. The error of the mean of two ends is at most half of their difference, if light changes
// monotonically.
real lightErrorOf(CellInterval cell)
{
  real change = changeOfLight(cell.enterShade.lit, cell.leaveShade.lit);
  real error = real(0.5) * change * (cell.shadesWithin.y - cell.shadesWithin.x);
#if TETMARCH_VERTEX_LIGHT_ERROR
  error = error + cell.interpolationError;
#endif
  return error;
}
#endif

#if TETMARCH_VERTEX_LIGHT_ERROR
// Half of the difference of the light at the corners.
real lightInterpolationError(FaceIntersection face)
{
  vec4 a = face.attributesA.light;
  vec4 b = face.attributesB.light;
  vec4 c = face.attributesC.light;
  real most = max(max(a.x, max(b.x, c.x)) - min(a.x, min(b.x, c.x)),
    max(a.y, max(b.y, c.y)) - min(a.y, min(b.y, c.y)));
  most = max(most, max(a.z, max(b.z, c.z)) - min(a.z, min(b.z, c.z)));
  return real(0.5) * max(most, max(a.w, max(b.w, c.w)) - min(a.w, min(b.w, c.w)));
}
#endif
