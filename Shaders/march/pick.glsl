// Where a ray is picked, between two depths.

#if TETMARCH_EXTREME || TETMARCH_SUM
CONSTANT real PICK_ROUNDING = real(1e-6); // of scalars, 0..1, and of shares of a sum
#endif

// Of volumes and surfaces, where it has gathered the opacity 1 - left. Of scalars, which are seen only when all of the
// ray is known, and if their opacity is as much: the first point with the greatest or least one; or the one up to which
// that share of the sum has been gathered.
Pick pickOn(
  Ray ray, int firstFace, real thicknessPerDepth, real depthBegin, real depthEnd, real left)
{
  March march = beginMarch(depthBegin);
#if TETMARCH_COMPOSITE
  march.target = -left;
#elif TETMARCH_ISOSURFACES
  // Their opacity may be the very one that is asked for, but for rounding: 2^-22.
  march.target = -left - real(2.384185791015625e-7);
#else
  Radiance whole = castPlainRay(ray, firstFace, thicknessPerDepth, depthBegin, depthEnd).radiance;
  // Rounding may make the second march gather a little less.
#if TETMARCH_SUM
  real target = gathered(whole) * min(real(1) - left, real(1) - PICK_ROUNDING);
#else
  real target = gathered(whole) - PICK_ROUNDING;
#endif
  real opacity = pixelOf(whole, thicknessPerDepth).w;
  march.target = opacity > real(0) && opacity + PICK_ROUNDING >= real(1) - left ? target : NO_DEPTH;
#endif
  Traversal traversal = traversalFromBoundary(ray, firstFace);
  marchOn(ray, thicknessPerDepth, depthEnd, traversal, march);
  return march.pick;
}
