// Surfaces of constant scalar (blend mode isosurface; Parker et al., "Interactive ray tracing for isosurface rendering",
// 1998), composited front to back. A value is crossed if one end of a piece has reached it and the other has not: so one
// that a face or a vertex has counts once.

// How many of the values the scalar has reached.
int valuesReached(real scalar)
{
  int reached = 0;
  for (int i = 0; i < isoSurfaceCount; ++i)
  {
    reached = reached + (scalar >= fetchIsoValue(i) ? 1 : 0);
  }
  return reached;
}

bool crossesSurface(Segment piece) { return valuesReached(piece.begin.y) != valuesReached(piece.end.y); }

#if TETMARCH_LIT
// How far in the piece its scalar has that value. Scalars of cells change where they begin.
real shareOfSurface(Segment piece, real value)
{
#if TETMARCH_POINT_SCALARS
  return clamp((value - piece.begin.y) / (piece.end.y - piece.begin.y), real(0), real(1));
#else
  return real(0);
#endif
}
#endif

int gatherSegment(Segment piece, real thicknessPerDepth, INOUT(CellInterval) cell, INOUT(Radiance) radiance)
{
#if TETMARCH_EFFECTS
  cell.shades.within = shareOf(cell, piece);
#endif
  int next = valuesReached(piece.begin.y);
  int last = valuesReached(piece.end.y);
  bool ascends = next < last;
  while (next != last)
  {
    int surface = ascends ? next : next - 1;
    vec4 color = fetchIsoColor(surface);
    vec4 mean = vec4(color.x * color.w, color.y * color.w, color.z * color.w, color.w);
#if TETMARCH_LIT
    Shade shade = shadeWithin(cell.shades, shareOfSurface(piece, fetchIsoValue(surface)));
    vec3 emitted = reflection(mean, shade.lit.direct);
#else
    vec3 emitted = emission(mean);
#endif
    radiance.color = radiance.color + emitted * radiance.transmittance;
    radiance.transmittance = radiance.transmittance * (real(1) - color.w);
    next = ascends ? next + 1 : next - 1;
  }
  return 1;
}
