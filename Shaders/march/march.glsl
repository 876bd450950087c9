// The march of a ray from its entry into the volume, from cell to cell, to its end. Cells are defined in tet/ or
// structured/: both have a RayPosition (the position of a ray), a Traversal, and crossCell().

struct March
{
  Radiance radiance;
  real done;     // depth up to which the ray is integrated; no part is integrated twice
  bool finished; // the ray is opaque or picked, or beyond its last depth
  int cells;     // cells crossed
  int stepsTaken; // the same including parts of cells; at most mostSteps
#if TETMARCH_SAMPLED_SHADOWS
  SamplePause pause;
#endif
#if TETMARCH_PICKED
  real target;   // gathered() at the picked point
  Pick pick;
#endif
#if TETMARCH_VISITS
  real begin;      // depth at which the ray entered the current visit
  real hiddenFrom; // entries behind this depth are invisible
#endif
#if TETMARCH_DIAGNOSTICS
  int lookups;   // of the segment integral
  int refused;   // entry faces that refused the ray
  int lost;      // cells without an exit
  int guarded;   // marches stopped by the step guard
#endif
};

March beginMarch(real depthBegin)
{
  March march;
  march.radiance = noRadiance();
  march.done = depthBegin;
  march.finished = false;
  march.cells = 0;
  march.stepsTaken = 0;
#if TETMARCH_SAMPLED_SHADOWS
  march.pause = noPause();
#endif
#if TETMARCH_PICKED
  march.target = NO_DEPTH; // more than gathered() of any ray
  march.pick = noPick();
#endif
#if TETMARCH_VISITS
  march.begin = depthBegin;
  march.hiddenFrom = NO_DEPTH;
#endif
#if TETMARCH_DIAGNOSTICS
  march.lookups = 0;
  march.refused = 0;
  march.lost = 0;
  march.guarded = 0;
#endif
  return march;
}

#if !TETMARCH_PICKED
void countLookups(int lookups, INOUT(March) march)
{
#if TETMARCH_DIAGNOSTICS
  march.lookups = march.lookups + lookups;
#endif
}
#endif

void countFaults(bool lost, INOUT(March) march)
{
#if TETMARCH_DIAGNOSTICS
  march.lost = march.lost + (lost ? 1 : 0);
  march.guarded = march.guarded + (march.stepsTaken >= mostSteps ? 1 : 0);
#endif
}

void countRefusal(bool entered, INOUT(March) march)
{
#if TETMARCH_DIAGNOSTICS
  march.refused = march.refused + (entered ? 0 : 1);
#endif
}

// Stores the cell ahead of the ray as the last crossed one: rays to the light may start in it.
void keepCell(RayPosition place, INOUT(CellInterval) cell, INOUT(March) march)
{
#if TETMARCH_PAUSES_WITHIN
  cell.before = place;
  march.pause.within = false;
#elif TETMARCH_SAMPLED_SHADOWS
  march.pause.start = startIn(place);
#endif
}

void keepTransmittance(INOUT(March) march)
{
#if TETMARCH_SAMPLED_SHADOWS && !TETMARCH_PAUSES_WITHIN
  march.pause.transmittance = march.radiance.transmittance;
#endif
}

#if TETMARCH_PAUSES_WITHIN
// After the last crossed cell was gathered. If the ray pauses within it, it crosses the rest again.
void keepPlace(CellInterval cell, INOUT(RayPosition) place, INOUT(bool) onward, INOUT(March) march)
{
  if (cell.seen)
  {
    march.pause.start = startIn(cell.before);
    march.pause.depth = cell.end;
  }
  if (march.pause.within)
  {
    place = cell.before;
    march.done = cell.end;
    march.cells = march.cells - march.pause.cells;
    march.stepsTaken = march.stepsTaken - 1;
    march.finished = false;
    onward = true;
  }
}
#endif

// Whether the march continues after the cell; it may pause there.
bool goesOnAfter(CellInterval cell, bool onward, INOUT(RayPosition) place, INOUT(March) march)
{
#if TETMARCH_SAMPLED_SHADOWS
#if TETMARCH_PAUSES_WITHIN
  keepPlace(cell, place, onward, march);
#else
  march.pause.seenDepth = cell.begin +
    (cell.end - cell.begin) * seenFraction(march.pause.transmittance, march.radiance.transmittance);
#endif
  march.pause.ended = !onward;
  march.pause.due = march.radiance.transmittance <= march.pause.nextSample;
  return onward && !march.pause.due;
#else
  return onward;
#endif
}

// The CPU reference can record each cell that a ray crosses (Reference/KernelTrace.h).
void recordCell(CellInterval cell, March march)
{
#if TETMARCH_TRACED
  traceCell(cell, march);
#endif
}

// Crosses the cell ahead of the ray. Returns whether the ray continues after it.
bool passCell(Ray ray, real depthEnd, INOUT(RayPosition) place, INOUT(CellInterval) cell, INOUT(March) march)
{
  keepCell(place, cell, march);
  Crossing crossing = crossCell(ray, place, cell);
  advanceShades(cell);
  march.cells = march.cells + crossing.cells;
  march.stepsTaken = march.stepsTaken + 1;
#if TETMARCH_PAUSES_WITHIN
  march.pause.cells = crossing.cells;
#endif
#if TETMARCH_COUNTS_TURNS
  countTurns(1);
#endif

  // An inverted tetrahedron is left before it is entered; overlaps are cut off likewise.
  cell.begin = largerOf(cell.enter.x, march.done);
  cell.end = smallerOf(cell.leave.x, depthEnd);
  bool forward = cell.end > cell.begin;
  decideVisibility(forward, cell);
  // If the ray goes backwards, nothing is integrated.
  march.done = forward ? cell.end : march.done;
  march.finished = largerOf(cell.begin, cell.end) >= depthEnd;
  recordCell(cell, march);
  cropCell(ray, cell);
  countFaults(crossing.lost, march);
  return crossing.onward && march.stepsTaken < mostSteps && !march.finished;
}

// Crosses transparent cells up to the next visible one, or one cell if there is no inner loop. Returns whether the ray
// continues after it. Mesa 22.3 miscompiles this loop as a do-while.
bool passToSeenCell(Ray ray, real depthEnd, INOUT(RayPosition) place, INOUT(CellInterval) cell, INOUT(March) march)
{
#if TETMARCH_PASSES_CELLS
#if TETMARCH_TRANSPARENT_RANGES
  // The loop runs at least once, which a compiler doesn't know: it would keep the last interval in registers.
  cell.begin = march.done;
  cell.end = march.done;
  cell.enter = cell.leave;
#endif
  bool onward = true;
  bool passing = true;
  while (passing && march.stepsTaken < mostSteps)
  {
    onward = passCell(ray, depthEnd, place, cell, march);
    passing = onward && !cell.seen;
  }
  return onward;
#else
  return passCell(ray, depthEnd, place, cell, march);
#endif
}

// Gathers the cell's interval, if it is visible.
void gatherInterval(Ray ray, real thicknessPerDepth, INOUT(CellInterval) cell, INOUT(March) march)
{
  if (cell.seen)
  {
#if TETMARCH_PICKED
    pickInterval(thicknessPerDepth, march.target, cell, march.radiance, march.pick);
#elif TETMARCH_LIGHT_AT_POINTS
    countLookups(gatherLit(thicknessPerDepth, cell, march.radiance), march);
#elif TETMARCH_LIT_PARTS && TETMARCH_PAUSES_WITHIN
    countLookups(gatherLitParts(ray, thicknessPerDepth, cell, march.radiance, march.pause), march);
#elif TETMARCH_PAUSES_WITHIN
    countLookups(gatherToSample(thicknessPerDepth, cell, march.radiance, march.pause), march);
#elif TETMARCH_LIT_PARTS
    countLookups(gatherLitParts(ray, thicknessPerDepth, cell, march.radiance), march);
#else
    countLookups(gatherCell(thicknessPerDepth, cell, march.radiance), march);
#endif
  }
}

// Gathers all intervals of the cell that remain after cropping.
void gatherIntervals(Ray ray, real thicknessPerDepth, INOUT(CellInterval) cell, INOUT(March) march)
{
#if TETMARCH_CROPPED
  bool cropping = cell.seen;
  int ranges = 0;
  while (cropping && ranges < mostRanges())
  {
    ranges = ranges + 1;
    gatherInterval(ray, thicknessPerDepth, cell, march);
#if TETMARCH_PAUSES_WITHIN
    if (march.pause.within)
    {
      return;
    }
#endif
    cropping = nextRangeOfCell(ray, cell);
  }
#else
  gatherInterval(ray, thicknessPerDepth, cell, march);
#endif
}

// Whether cells behind can't change the result.
bool isFinished(March march)
{
#if TETMARCH_PICKED
  return march.finished || march.pick.hit;
#else
  return march.finished || isOpaque(march.radiance);
#endif
}

CONSTANT int STEPS_OF_RUN = 16;

// The steps after which the march comes back. Rays of a group leave the mesh at different times, and those that have
// left wait for the others before they search their next entry: not for longer than a run. Without runs, the steps are
// a uniform that a compiler need not keep.
int endOfRun(int begin)
{
#if TETMARCH_REENTERED
  return min(begin + STEPS_OF_RUN, mostSteps);
#else
  return mostSteps;
#endif
}

// Whether the ray is still in the volume after a run. Without runs it has left: the compiler must see that.
bool staysInside(bool onward)
{
#if TETMARCH_REENTERED
  return onward;
#else
  return false;
#endif
}

// Marches from the ray's entry into the volume to its exit, which becomes the place, or to the end of a run: then it
// returns true. thicknessPerDepth is the thickness, in scalar opacity unit distances, of a unit of depth.
bool marchToExit(Ray ray, INOUT(RayPosition) place, real thicknessPerDepth, real depthEnd, INOUT(March) march)
{
  CellInterval cell = beginCellInterval(ray, place);
  int begin = march.stepsTaken;
  bool onward = true;
  while (onward && march.stepsTaken < endOfRun(begin))
  {
    onward = passToSeenCell(ray, depthEnd, place, cell, march);
    keepTransmittance(march);
    shadeCell(ray, place, cell);
    gatherIntervals(ray, thicknessPerDepth, cell, march);
    march.finished = isFinished(march);
    onward = onward && !march.finished;
    onward = goesOnAfter(cell, onward, place, march);
  }
  return onward;
}

#if TETMARCH_VISITS
bool hasSeen(March march)
{
#if TETMARCH_ACCUMULATES_OPACITY
  return march.radiance.transmittance < real(1);
#else
  return false; // the whole ray is one visit
#endif
}
#endif

// Sets the begin of a visit of the mesh; invisible visits are skipped.
void beginVisit(Traversal traversal, INOUT(March) march)
{
#if TETMARCH_VISITS
  bool begins = !traversal.inside && !hasSeen(march);
  march.begin = begins ? max(traversal.entry.depth, march.done) : march.begin;
#endif
}

// Whether the ray marches through its next entry, or continues in the volume.
bool goesOnThrough(Traversal traversal, March march)
{
#if TETMARCH_VISITS
  return traversal.inside || (!hasSeen(march) && traversal.entry.depth <= march.hiddenFrom);
#else
  return true;
#endif
}

// Marches to the end of the ray or of a visit, or to the next pause.
void marchOn(Ray ray, real thicknessPerDepth, real depthEnd, INOUT(Traversal) traversal, INOUT(March) march)
{
  int entries = 0;
  while (goesOnThrough(traversal, march) && continuesBefore(traversal, depthEnd) && march.stepsTaken < mostSteps &&
    entries < mostSteps)
  {
    entries = entries + 1;
    beginVisit(traversal, march);
    enterVolume(ray, depthEnd, traversal);
#if TETMARCH_SAMPLED_SHADOWS
    bool onward = traversal.entered && !march.pause.ended;
#else
    bool onward = traversal.entered;
#endif
    if (onward)
    {
      onward = staysInside(marchToExit(ray, traversal.place, thicknessPerDepth, depthEnd, march));
    }
#if TETMARCH_SAMPLED_SHADOWS
    if (march.pause.due)
    {
      return;
    }
    march.pause.ended = false;
#endif
    if (!onward)
    {
      countRefusal(traversal.entered, march);
      leaveVolume(ray, march.finished, traversal);
    }
  }
}
