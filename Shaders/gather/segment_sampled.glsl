// Emission and absorption along a segment by samples of a fixed step (Levoy, "Display of surfaces from volume data",
// 1988), as in vtkGPUVolumeRayCastMapper. A sample represents the step in front of it: its scalar is interpolated, then
// classified, and determines the emission and absorption of a length of one step. Features between samples are missed,
// and there is no error bound.

#if TETMARCH_EFFECTS
// The shade of a sample replaces those at the ends of the interval.
void shadeSample(real depth, real scalar, INOUT(CellInterval) cell)
{
  FacePoint point;
  point.depth = depth;
  point.scalar = scalar;
  point.attributes = attributesAt(cell.ray, cell.crossed, depth);
  cell.enterShade = shadeAtFace(cell.ray, point);
  cell.leaveShade = cell.enterShade;
}
#endif

// Returns the number of samples.
int integrateSegment(Segment segment, real thickness, INOUT(CellInterval) cell, INOUT(Radiance) radiance)
{
  int k = samplesBefore(cell.ray, segment.begin.x);
  int behind = samplesBefore(cell.ray, segment.end.x);
  real stepThickness = thickness * (sampleStep / (segment.end.x - segment.begin.x));
  int samples = 0;
  bool pending = true;
  while (pending && k < behind)
  {
    Segment point = segment;
#if TETMARCH_POINT_SCALARS || TETMARCH_EFFECTS
    real depth = clamp(depthOfSample(cell.ray, k), segment.begin.x, segment.end.x);
#endif
#if TETMARCH_POINT_SCALARS
    point.begin.y = scalarIn(cell, depth);
#endif
#if TETMARCH_EFFECTS
    shadeSample(depth, point.begin.y, cell);
#endif
    vec4 value = constantMean(point);
    Absorption by = absorption(value, thicknessWithin(cell, real(0.5), stepThickness));
    addSubsegment(value, by, real(0.5), real(1), cell, radiance);
    k = k + 1;
    samples = samples + 1;
    pending = !isOpaque(radiance);
  }
  return samples;
}
