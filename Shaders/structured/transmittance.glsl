// The transmittance of a ray towards the light, from a point over a distance in a direction (unit length).

#if TETMARCH_SAMPLED_SHADOWS
// The march of the picture pauses for samples, so that rays towards the light have their own march. It sums the optical
// depth over cells; the transmittance is one exponential at the end. Each part of a cell is integrated as if the scalar
// were linear between its ends.

#if TETMARCH_POINT_SCALARS && TETMARCH_LIGHT_TOLERANCE
// Along the scalar's cubic, in four straight pieces.
real meanExtinction(Segment segment)
{
  real mean = real(0);
  real from = segment.begin.y;
  for (int k = 1; k <= 4; ++k)
  {
    real to = bentScalar(segment.begin.y, segment.end.y, segment.bend, real(k) * real(0.25));
    mean = mean +
      meanOver(from * tableScale + tableOffset, to * tableScale + tableOffset).mean.w * real(0.25);
    from = to;
  }
  return mean;
}
#elif TETMARCH_POINT_SCALARS
real meanExtinction(Segment segment)
{
  return meanOver(segment.begin.y * tableScale + tableOffset, segment.end.y * tableScale + tableOffset).mean.w;
}
#else
real meanExtinction(Segment segment) { return tableValue(segment.begin.y * tableScale + tableOffset).w; }
#endif

// Optical depth per unit of depth in the visible part of the cell.
real cellExtinction(Ray ray, RayPosition place, CellInterval cell)
{
  real extinction = meanExtinction(visibleSegment(cell));
#if TETMARCH_GRADIENT_OPACITY
  extinction =
    extinction * gradientOpacity(gradientAt(ray, place.crossed, real(0.5) * (cell.begin + cell.end)));
#endif
#if TETMARCH_NAN_SHOWN
  extinction = cell.finite ? extinction : nanColor.w;
#endif
  return extinction;
}

// Adds the optical depth of the next cell of a ray between two depths. Returns whether more cells follow.
bool passCell(Ray ray, vec2 range, real thicknessPerDepth, INOUT(Traversal) traversal, INOUT(CellInterval) cell,
  INOUT(real) opticalDepth)
{
  Crossing crossing = crossCell(ray, traversal.place, cell);
  cell.begin = max(cell.enter.x, range.x);
  cell.end = min(cell.leave.x, range.y);
  decideVisibility(cell.end > cell.begin, cell);
  real extinction = cellExtinction(ray, traversal.place, cell);
  opticalDepth = opticalDepth + (cell.seen ? extinction * (cell.end - cell.begin) * thicknessPerDepth : real(0));
  return crossing.onward && cell.leave.x < range.y;
}

real transmittanceTo(LightStart start, vec3 direction, real distance)
{
  Ray ray = rayThrough(start.point, direction);
  vec2 range = lightRange(ray, dot(start.point - ray.origin, ray.direction), distance);
  real thicknessPerDepth = thicknessPerDepthAlong(direction);
  real darkDepth = -log(errorTolerance);
  Traversal traversal = traversalFrom(ray, range.x);
  enterVolume(ray, range.y, traversal);
  CellInterval cell = beginCellInterval(ray, traversal.place);
  real opticalDepth = real(0);
  bool onward = continuesBefore(traversal, range.y);
  int steps = 0;
  while (onward && steps < mostSteps)
  {
    steps = steps + 1;
    onward = passCell(ray, range, thicknessPerDepth, traversal, cell, opticalDepth) && opticalDepth <= darkDepth;
#if TETMARCH_LIMITS_TURNS
    // Two cells a turn: fewer rays reach the limit, and end early.
    if (onward)
    {
      onward = passCell(ray, range, thicknessPerDepth, traversal, cell, opticalDepth) && opticalDepth <= darkDepth;
    }
#endif
  }
#if TETMARCH_COUNTS_TURNS
  countTurns(steps + 1);
#endif
  return exp(-opticalDepth);
}
#else
real transmittanceTo(LightStart start, vec3 direction, real distance)
{
  Ray ray = rayThrough(start.point, direction);
  vec2 range = lightRange(ray, dot(start.point - ray.origin, ray.direction), distance);
  return castPlainRay(ray, thicknessPerDepthAlong(direction), range.x, range.y).radiance.transmittance;
}
#endif
