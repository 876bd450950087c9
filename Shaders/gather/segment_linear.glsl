// Emission and absorption along a segment in which the scalars are linear.
//
// A subsegment is evaluated with its exact means of C tau and tau, as if colour and extinction were spread evenly in it
// (Engel, Kraus and Ertl 2001; gather/order_error.glsl bounds what that loses). The adaptive rule accepts a subsegment
// if its error, seen through what lies in front, fits the budget of the pixel: the tolerance is spread over what the ray
// absorbs, less what the subsegments before have used. So a pixel keeps its tolerance however many cells it sees. A
// subsegment that is not accepted is tried again with a shorter one.

// Along a thickness in scalar opacity unit distances. Returns the number of trials. Where the table at the segment's
// begin is not the one of the last lookup, the first trial only reads the table there. The body stands at the end of one
// loop that mostly runs once: an `if` costs a software renderer as much as both its branches.
int integrateSegment(Segment segment, real thickness, INOUT(CellInterval) cell, INOUT(Radiance) radiance)
{
  SegmentEnds ends = segmentEnds(segment);
  bool loaded = isLoaded(ends, cell);
  real position = real(0); // how far the segment is integrated, 0..1
  real pieces = real(1);   // into which the rest is cut; the first is tried
  // Numbers that are not finite do not keep the loop alive. Others never take as many turns: behind mostTrials pieces are
  // accepted as they are, and grow. Where two turns are all, the bound is a uniform, so that the loop is not unrolled.
#if TETMARCH_ADAPTIVE
  int mostTurns = 16 * mostTrials + 2;
#else
  int mostTurns = mostSteps;
#endif
  int trials = 0; // from mostTrials on all are accepted
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
    error = error * brightness(illuminationWithin(cell.shades, middle));
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
      addLookup(loaded ? perBinsOf(found, cell) : real(0), by, middle, cell, radiance);
#endif
      addSubsegment(found.mean, by, middle, part.fraction, cell, radiance);
#if TETMARCH_ERROR_BOUND
      radiance.error = radiance.error + error;
#endif
      pending = !(loaded && part.last) && !isOpaque(radiance) && trials < mostTurns;
      position = loaded ? position + part.fraction : position;
      keepTablePoint(found, cell);
    }
#if TETMARCH_ADAPTIVE
    // The error grows with the third power of a piece, what it earns with the first. The rest is cut evenly.
    real finer = real(1.25) * sqrt(error / budget);
    real left = loaded && accepted ? part.pieces - real(1) : part.pieces;
    pieces = -floor(-left * (accepted ? clamp(finer, real(0.5), real(1)) : clamp(finer, real(2), real(10))));
#endif
    loaded = loaded || accepted;
    trials = trials + 1;
  } while (pending);
  return trials;
}
