// The picked point of a ray between two depths.

#if TETMARCH_KNOWN_AT_END
CONSTANT real PICK_ROUNDING = real(1e-6); // of scalars, 0..1, and of a sum in proportion
#endif

// Volumes and surfaces are picked where the ray reaches the opacity 1 - left. Extremes and sums are known only at the
// end of the ray, and are picked if their opacity is at least that: an extreme at its first point, a sum where that
// proportion of it is reached.
Pick pickOn(
  Ray ray, real thicknessPerDepth, real depthBegin, real depthEnd, real left)
{
  March march = beginMarch(depthBegin);
#if TETMARCH_COMPOSITE
  march.target = -left;
#elif TETMARCH_ISOSURFACES
  // The opacity of a surface may equal the threshold up to rounding: 2^-22.
  march.target = -left - real(2.384185791015625e-7);
#else
  Radiance whole = castPlainRay(ray, thicknessPerDepth, depthBegin, depthEnd).radiance;
  // The second march may gather slightly less by rounding.
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
