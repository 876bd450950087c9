// Gathers a visible cell between cell.begin and cell.end. Returns the number of lookups of the segment integral.
int gatherCell(real thicknessPerDepth, INOUT(CellInterval) cell, INOUT(Radiance) radiance)
{
  int lookups = 0;
#if TETMARCH_NAN_SHOWN
  if (!cell.finite)
  {
    absorbNan(radiance, (cell.end - cell.begin) * thicknessPerDepth);
  }
  else
#endif
  {
    lookups = gatherSegment(visibleSegment(cell), thicknessPerDepth, cell, radiance);
  }
  return lookups;
}
