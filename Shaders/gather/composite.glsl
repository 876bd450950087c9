// Emission and absorption, front to back (blend mode composite).

// Returns the lookups of the segment integral that it took.
int gatherSegment(Segment segment, real thicknessPerDepth, INOUT(CellInterval) cell, INOUT(Radiance) radiance)
{
  placeShades(segment, cell);
  return integrateSegment(segment, (segment.end.x - segment.begin.x) * thicknessPerDepth, cell, radiance);
}
