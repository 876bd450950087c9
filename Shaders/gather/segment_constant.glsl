// Emission and absorption along a segment with constant scalars: exact in closed form, except for light that changes
// along it.
int integrateSegment(Segment segment, real thickness, INOUT(CellInterval) cell, INOUT(Radiance) radiance)
{
#if TETMARCH_LIT_COMPONENTS
  vec4 mean = constantMean(segment, cell);
#else
  vec4 mean = constantMean(segment);
#endif
  Absorption by = absorption(mean, thicknessWithin(cell, real(0.5), thickness));
  addSubsegment(mean, by, real(0.5), real(1), cell, radiance);
  return 1;
}
