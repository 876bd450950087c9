// Emission and absorption, front to back (blend mode composite).

// Returns the lookups of the integral that it took.
int gatherSegment(Segment piece, real thicknessPerDepth, INOUT(CellInterval) cell, INOUT(Radiance) radiance)
{
  real thickness = (piece.end.x - piece.begin.x) * thicknessPerDepth;
#if TETMARCH_INDEPENDENT
  vec4 begin = scalarsOf(piece.begin.y, piece.furtherBegin);
#if TETMARCH_POINT_SCALARS
  return integrateSegment(begin, scalarsOf(piece.end.y, piece.furtherEnd), thickness, radiance);
#else
  integrateConstant(begin, thickness, radiance);
  return 1;
#endif
#else
#if TETMARCH_EFFECTS
  cell.shades.within = shareOf(cell, piece);
#endif
  real tableBegin = piece.begin.y * tableScale + tableOffset;
#if TETMARCH_POINT_SCALARS
  real tableEnd = piece.end.y * tableScale + tableOffset;
#if TETMARCH_EFFECTS && TETMARCH_DEPENDENT
  return integrateSegment(tableBegin, tableEnd, thickness, piece.furtherBegin, piece.furtherEnd,
    cell.shades, cell.at, radiance);
#elif TETMARCH_EFFECTS
  return integrateSegment(tableBegin, tableEnd, thickness, cell.shades, cell.at, radiance);
#elif TETMARCH_DEPENDENT
  return integrateSegment(
    tableBegin, tableEnd, thickness, piece.furtherBegin, piece.furtherEnd, cell.at, radiance);
#else
  return integrateSegment(tableBegin, tableEnd, thickness, cell.at, radiance);
#endif
#else
#if TETMARCH_EFFECTS && TETMARCH_DEPENDENT
  integrateConstant(tableBegin, thickness, piece.furtherBegin, cell.shades, radiance);
#elif TETMARCH_EFFECTS
  integrateConstant(tableBegin, thickness, cell.shades, radiance);
#elif TETMARCH_DEPENDENT
  integrateConstant(tableBegin, thickness, piece.furtherBegin, radiance);
#else
  integrateConstant(tableBegin, thickness, radiance);
#endif
  return 1;
#endif
#endif
}
