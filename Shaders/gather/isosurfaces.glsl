// Surfaces of constant scalar (blend mode isosurface; Parker et al., "Interactive ray tracing for isosurface rendering",
// 1998), composited front to back. A segment crosses a value if one end has reached it and the other has not: so the
// value of a whole face or of a vertex is crossed once.

// The emission of a surface of this colour and opacity, crossed where the segment has the value.
vec3 surfaceEmission(vec4 color, real value, Segment segment, CellInterval cell)
{
  vec4 mean = vec4(color.x * color.w, color.y * color.w, color.z * color.w, color.w);
#if TETMARCH_LIT
  return reflection(mean, illuminationWithin(cell, fractionOfValue(segment, value)).direct);
#else
  return emission(mean);
#endif
}

int gatherSegment(Segment segment, real thicknessPerDepth, INOUT(CellInterval) cell, INOUT(Radiance) radiance)
{
  placeShades(segment, cell);
  int next = valuesReached(segment.begin.y);
  int last = valuesReached(segment.end.y);
  bool ascends = next < last;
  int crossed = ascends ? last - next : next - last;
  while (crossed > 0)
  {
    int surface = ascends ? next : next - 1;
    vec4 color = fetchIsoColor(surface);
    vec3 emitted = surfaceEmission(color, fetchIsoValue(surface), segment, cell);
    radiance.color = radiance.color + emitted * radiance.transmittance;
    radiance.transmittance = radiance.transmittance * (real(1) - color.w);
    next = ascends ? next + 1 : next - 1;
    crossed = crossed - 1;
  }
  return 1;
}
