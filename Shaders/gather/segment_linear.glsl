// Emission and absorption along a segment in which the scalars are linear.
//
// A subsegment is evaluated with its exact means of C tau and tau, as if colour and extinction were distributed evenly
// in it (Engel, Kraus and Ertl 2001; gather/order_error.glsl bounds the error). The adaptive rule accepts a subsegment
// if its error, attenuated by the transmittance, fits the budget of the pixel: the tolerance is distributed in
// proportion to the ray's absorption, minus the part used by previous subsegments. So a pixel keeps its tolerance for
// any number of cells. If a subsegment is not accepted, a shorter one is tried.

// Along a thickness in scalar opacity unit distances. Returns the number of trials. If the table at the segment's begin
// is not that of the last lookup, the first trial only reads the table there. The body is at the end of one loop that
// usually runs once: an `if` costs a software renderer as much as both its branches.
int integrateSegment(Segment segment, real thickness, INOUT(CellInterval) cell, INOUT(Radiance) radiance)
{
  SegmentEnds ends = segmentEnds(segment);
#if !TETMARCH_KEEPS_TABLE_POINT
  bool loaded = true; // each lookup reads both ends
#elif TETMARCH_CORNER_SCALARS
  cell.at = tablePoint(ends.begin); // mostly the scalar has jumped
  bool loaded = true;
#else
  bool loaded = cell.at.x == ends.begin; // by the last lookup, as is usual
#endif
  real position = real(0); // the integrated fraction of the segment, 0..1
  real pieces = real(1);   // number of pieces of the rest; the first is tried
  // The loop also ends if numbers are not finite. Otherwise this limit is never reached: after mostTrials pieces are
  // accepted unchecked, and grow. For two iterations the bound is a uniform, so that the loop is not unrolled.
#if TETMARCH_ADAPTIVE
  int mostTurns = 16 * mostTrials + 2;
#else
  int mostTurns = mostSteps;
#endif
  int trials = 0; // from mostTrials on all pieces are accepted
  bool pending = true;
  do
  {
    Subsegment part = subsegmentFrom(position, pieces);
    SubsegmentMean found = meanOfSubsegment(ends, part, loaded, cell);
    real middle = position + real(0.5) * part.fraction;
    Absorption by =
      absorption(found.mean, thicknessWithin(cell, middle, loaded ? part.fraction * thickness : real(0)));
#if TETMARCH_ERROR_BOUND
    real error = loaded ? subsegmentError(ends, part, found, by, cell, radiance.transmittance) : real(0);
#if TETMARCH_LIT
    error = error * brightness(illuminationWithin(cell, middle));
#endif
#endif
#if TETMARCH_ADAPTIVE
    real budget = errorBudget(radiance, radiance.transmittance * by.absorbed);
    bool accepted = error <= budget || trials >= mostTrials;
#else
    bool accepted = true;
#endif
    if (accepted)
    {
#if TETMARCH_TABLE_ERROR
      addLookup(loaded ? perBinsOf(found) : real(0), by, middle, cell, radiance);
#endif
      addSubsegment(found.mean, by, middle, part.fraction, cell, radiance);
#if TETMARCH_ERROR_BOUND
      radiance.error = radiance.error + error;
#endif
      pending = !(loaded && part.last) && !isOpaque(radiance) && trials < mostTurns;
      position = loaded ? position + part.fraction : position;
    }
#if TETMARCH_ADAPTIVE
    // The error grows with the third power of a piece's length, its budget with the first. The rest is cut evenly.
    real finer = real(1.25) * sqrt(error / budget);
    real left = loaded && accepted ? part.pieces - real(1) : part.pieces;
    pieces = -floor(-left * (accepted ? clamp(finer, real(0.5), real(1)) : clamp(finer, real(2), real(10))));
#endif
    loaded = loaded || accepted;
    trials = trials + 1;
#if TETMARCH_KEEPS_TABLE_POINT
    // Not in the branch above: as a selection of its own, it leaves the software renderer one copy, not two.
    if (accepted)
    {
      cell.at = found.next;
    }
#endif
  } while (pending);
  return trials;
}
