// The march: from where a ray enters the volume, from cell to cell, to where it ends. What the cells are is the
// business of tet/ or structured/: both have a Place, where a ray is, a Traversal, and crossCell().

struct March
{
  Radiance radiance;
  real done;     // depth up to which the ray has gathered; nothing is gathered twice
  bool finished; // the ray is opaque or picked, or past the last depth that is asked for
  int cells;     // cells crossed
  int stepsTaken; // the same, and parts of cells that were crossed: no ray takes more than mostSteps
#if TETMARCH_SAMPLED_SHADOWS
  SamplePause pause;
#endif
#if TETMARCH_PICKED
  real target;   // the ray is picked where it has gathered this much
  Pick pick;
#endif
#if TETMARCH_VISITS
  real begin;      // depth at which the ray has entered what it has gathered
  real hiddenFrom; // where it enters behind this depth nothing is seen
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
  march.target = NO_DEPTH; // more than any ray gathers
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

// Keeps the cell before which the ray is as the one that was crossed last: rays to the light may start in it.
void keepCell(Place place, INOUT(March) march)
{
#if TETMARCH_SAMPLED_SHADOWS
  march.pause.start = startIn(place);
#endif
}

void keepTransmittance(INOUT(March) march)
{
#if TETMARCH_SAMPLED_SHADOWS
  march.pause.transmittance = march.radiance.transmittance;
#endif
}

// Whether the march goes on behind the cell; it may pause there.
bool goesOnAfter(CellInterval cell, bool onward, INOUT(March) march)
{
#if TETMARCH_SAMPLED_SHADOWS
  march.pause.seenDepth = cell.begin +
    (cell.end - cell.begin) * seenFraction(march.pause.transmittance, march.radiance.transmittance);
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

// Crosses the cell before which the ray is. Returns whether the ray goes on behind it.
bool passCell(Ray ray, real depthEnd, INOUT(Place) place, INOUT(CellInterval) cell, INOUT(March) march)
{
  keepCell(place, march);
  Crossing crossing = crossCell(ray, place, cell);
  advanceShades(cell);
  march.cells = march.cells + crossing.cells;
  march.stepsTaken = march.stepsTaken + 1;

  // An inverted tetrahedron is left before it is entered; overlaps are cut off likewise.
  cell.begin = max(cell.enter.x, march.done);
  cell.end = min(cell.leave.x, depthEnd);
  bool forward = cell.end > cell.begin;
  decideVisibility(forward, cell);
  // Where the ray goes backwards, nothing is gathered.
  march.done = forward ? cell.end : march.done;
  march.finished = max(cell.begin, cell.end) >= depthEnd;
  recordCell(cell, march);
  cropCell(ray, cell);
  countFaults(crossing.lost, march);
  return crossing.onward && march.stepsTaken < mostSteps && !march.finished;
}

// Crosses cells until something is seen of one, or one cell if none is to be passed unseen. Returns whether the ray goes
// on behind it. What is not seen has a loop of its own; Mesa 22.3 compiles it wrong as a do-while.
bool passToSeenCell(Ray ray, real depthEnd, INOUT(Place) place, INOUT(CellInterval) cell, INOUT(March) march)
{
#if TETMARCH_PASSES_CELLS
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

// Gathers the cell's interval, if anything of it is seen.
void gatherInterval(real thicknessPerDepth, INOUT(CellInterval) cell, INOUT(March) march)
{
  if (cell.seen)
  {
#if TETMARCH_PICKED
    pickInterval(thicknessPerDepth, march.target, cell, march.radiance, march.pick);
#else
    countLookups(gatherCell(thicknessPerDepth, cell, march.radiance), march);
#endif
  }
}

// Gathers all intervals of the cell that the cropping leaves.
void gatherIntervals(Ray ray, real thicknessPerDepth, INOUT(CellInterval) cell, INOUT(March) march)
{
#if TETMARCH_CROPPED
  bool cropping = cell.seen;
  int ranges = 0;
  while (cropping && ranges < mostRanges())
  {
    ranges = ranges + 1;
    gatherInterval(thicknessPerDepth, cell, march);
    cropping = nextRangeOfCell(ray, cell);
  }
#else
  gatherInterval(thicknessPerDepth, cell, march);
#endif
}

// Whether nothing behind can change what is asked for.
bool isFinished(March march)
{
#if TETMARCH_PICKED
  return march.finished || march.pick.hit;
#else
  return march.finished || isOpaque(march.radiance);
#endif
}

// Marches from where the ray has entered the volume to where it leaves it, which becomes the place. thicknessPerDepth is
// the thickness, in scalar opacity unit distances, of a unit of depth.
void marchToExit(Ray ray, INOUT(Place) place, real thicknessPerDepth, real depthEnd, INOUT(March) march)
{
  CellInterval cell = beginCellInterval(ray, place);
  bool onward = true;
  while (onward && march.stepsTaken < mostSteps)
  {
    onward = passToSeenCell(ray, depthEnd, place, cell, march);
    keepTransmittance(march);
    shadeCell(ray, place, cell);
    gatherIntervals(ray, thicknessPerDepth, cell, march);
    march.finished = isFinished(march);
    onward = onward && !march.finished;
    onward = goesOnAfter(cell, onward, march);
  }
}

#if TETMARCH_VISITS
bool hasSeen(March march)
{
#if TETMARCH_ACCUMULATES_OPACITY
  return march.radiance.transmittance < real(1);
#else
  return false; // all that is on the ray is one visit
#endif
}
#endif

// Where a visit of the mesh begins; those of which nothing is seen are none.
void beginVisit(Traversal traversal, INOUT(March) march)
{
#if TETMARCH_VISITS
  bool begins = !traversal.inside && !hasSeen(march);
  march.begin = begins ? max(traversal.entry.depth, march.done) : march.begin;
#endif
}

// Whether the ray marches through what it enters next, or goes on in what it has entered.
bool goesOnThrough(Traversal traversal, March march)
{
#if TETMARCH_VISITS
  return traversal.inside || (!hasSeen(march) && traversal.entry.depth <= march.hiddenFrom);
#else
  return true;
#endif
}

// Marches to the end of the ray or of a visit, or up to where the march pauses.
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
      marchToExit(ray, traversal.place, thicknessPerDepth, depthEnd, march);
    }
#if TETMARCH_SAMPLED_SHADOWS
    if (march.pause.due)
    {
      return;
    }
    march.pause.ended = false;
#endif
    countRefusal(traversal.entered, march);
    leaveVolume(ray, march.finished, traversal);
  }
}
