// The traversal of a lattice from cell to cell (Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing",
// 1987), with leaps over transparent blocks of cells.

// The position of a ray: before a cell or, in a cell that is crossed in parts, before the next part.
struct RayPosition
{
  ivec3 cell;
  real depth;    // depth at which the ray enters the cell
  real leave;    // depth at which it leaves it
  real end;      // depth at which it leaves the lattice, or ends
#if TETMARCH_EFFECTS || TETMARCH_LIT_COMPONENTS
  ivec3 crossed; // the last crossed cell
#endif
#if TETMARCH_CELL_PARTS
  real position; // fraction of the cell that is crossed, 0..1; 1: it is not yet entered
  vec4 cubic;    // the scalar along the ray in it
  vec2 extremes;
#endif
#if TETMARCH_BENT_COMPONENTS
  ExtraCubics extra; // of extra scalars
#endif
};

#if TETMARCH_CELL_PARTS
bool isWithinCell(RayPosition place) { return place.position < real(1); }
#else
bool isWithinCell(RayPosition place) { return false; }
#endif

// The state of a ray: it enters a lattice once.
struct Traversal
{
  RayPosition place;
  bool entered; // the ray meets the lattice
  Entry entry;
};

// The traversal before the ray's first cell behind a depth.
Traversal traversalFrom(Ray ray, real depthBegin)
{
  vec2 range = depthsOfLattice(ray);
  bool meets = range.x < range.y;
  real depth = meets ? max(range.x, depthBegin) : real(0);
  ivec3 none = ivec3(0, 0, 0);
  ivec3 last = ivec3(latticeCells.x - 1, latticeCells.y - 1, latticeCells.z - 1);
  Traversal traversal;
  traversal.place.cell = cellBehindDepth(ray, depth, none, last);
  traversal.place.depth = depth;
  traversal.place.leave = depth;
  traversal.place.end = range.y;
#if TETMARCH_CELL_PARTS
  traversal.place.position = real(1);
  traversal.place.cubic = vec4(real(0), real(0), real(0), real(0));
  traversal.place.extremes = vec2(NO_EXTREME, NO_EXTREME);
#endif
#if TETMARCH_BENT_COMPONENTS
  traversal.place.extra = noExtraCubics();
#endif
#if TETMARCH_EFFECTS || TETMARCH_LIT_COMPONENTS
  traversal.place.crossed = traversal.place.cell;
#endif
  traversal.entered = meets;
  traversal.entry.depth = depth;
  traversal.entry.face = meets && depth < range.y ? 0 : -1;
  return traversal;
}

// Whether the ray enters the volume before that depth.
bool continuesBefore(Traversal traversal, real depthEnd)
{
  return traversal.entry.face >= 0 && traversal.entry.depth < depthEnd;
}

// The ray ends at the given depth.
void enterVolume(Ray ray, real depthEnd, INOUT(Traversal) traversal)
{
  traversal.place.end = min(traversal.place.end, depthEnd);
}

void leaveVolume(Ray ray, bool finished, INOUT(Traversal) traversal) { traversal.entry.face = -1; }
