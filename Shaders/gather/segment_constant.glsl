// Emission and absorption along a segment with constant scalars: exact in closed form, except for light that changes
// along it.
int integrateSegment(Segment segment, real thickness, INOUT(CellInterval) cell, INOUT(Radiance) radiance)
{
  vec4 mean = constantMean(segment);
  Absorption by = absorption(mean, thicknessWithin(cell, real(0.5), thickness));
  addSubsegment(mean, by, real(0.5), real(1), cell, radiance);
  return 1;
}
