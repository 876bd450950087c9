// Emission and absorption, front to back (blend mode composite).

// Returns the number of lookups of the segment integral.
int gatherSegment(Segment segment, real thicknessPerDepth, INOUT(CellInterval) cell, INOUT(Radiance) radiance)
{
  placeShades(segment, cell);
#if TETMARCH_CURVED_ERROR
  addCurvedError(segment, thicknessPerDepth, cell, radiance);
#endif
  return integrateSegment(segment, (segment.end.x - segment.begin.x) * thicknessPerDepth, cell, radiance);
}
