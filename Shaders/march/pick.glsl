// Where a ray is picked, between two depths.

#if TETMARCH_KNOWN_AT_END
CONSTANT real PICK_ROUNDING = real(1e-6); // of scalars, 0..1, and of a sum in proportion
#endif

// A volume, or surfaces, are picked where the ray has gathered the opacity 1 - left. Scalars are seen only when all of
// the ray is known, and are picked if their opacity is as much: an extreme at its first point, a sum where that
// proportion of it has been gathered.
Pick pickOn(
  Ray ray, real thicknessPerDepth, real depthBegin, real depthEnd, real left)
{
  March march = beginMarch(depthBegin);
#if TETMARCH_COMPOSITE
  march.target = -left;
#elif TETMARCH_ISOSURFACES
  // The opacity of a surface may be exactly what is asked for, but for rounding: 2^-22.
  march.target = -left - real(2.384185791015625e-7);
#else
  Radiance whole = castPlainRay(ray, thicknessPerDepth, depthBegin, depthEnd).radiance;
  // Rounding may make the second march gather a little less.
#if TETMARCH_SUM
  real target = gathered(whole) * min(real(1) - left, real(1) - PICK_ROUNDING);
#else
  real target = gathered(whole) - PICK_ROUNDING;
#endif
  real opacity = pixelOf(whole, thicknessPerDepth).w;
  march.target = opacity > real(0) && opacity + PICK_ROUNDING >= real(1) - left ? target : NO_DEPTH;
#endif
  Traversal traversal = traversalFrom(ray, depthBegin);
  marchOn(ray, thicknessPerDepth, depthEnd, traversal, march);
  return march.pick;
}
