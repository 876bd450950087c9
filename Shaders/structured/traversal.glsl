// The traversal of a lattice from cell to cell (Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing",
// 1987), with leaps over blocks of cells of which nothing can be seen.

// Where a ray is: before a cell or, in a cell in which the scalar bends, before the next part of it.
struct Place
{
  ivec3 cell;
  real depth;    // where the ray enters the cell
  real leave;    // where it leaves it
  real end;      // where it leaves the lattice
  real position; // up to where the cell is crossed, 0..1; 1: it is not yet entered
#if TETMARCH_EFFECTS
  ivec3 crossed; // the cell that was crossed last
#endif
#if TETMARCH_POINT_SCALARS
  vec4 cubic;    // the scalar along the ray in it
  vec2 extremes;
#endif
#if TETMARCH_BENT_COMPONENTS
  FurtherCubics further; // of the scalars beside it
#endif
};

// The state of a ray: it enters a lattice once.
struct Traversal
{
  Place place;
  bool entered; // the ray meets the lattice
  Entry entry;
};

// From the first cell that the ray meets behind a depth.
Traversal traversalFrom(Ray ray, int firstFace, real depthBegin)
{
  vec2 range = depthsOfLattice(ray);
  bool meets = range.x < range.y;
  real depth = meets ? max(range.x, depthBegin) : real(0);
  ivec3 none = ivec3(0, 0, 0);
  ivec3 last = ivec3(latticeCells.x - 1, latticeCells.y - 1, latticeCells.z - 1);
  Traversal traversal;
  traversal.place.cell = cellBehindDepth(ray, depth, none, last);
  traversal.place.depth = greatestOf(crossingDepths(ray, planesPassed(ray, traversal.place.cell), -NO_DEPTH));
  traversal.place.leave = traversal.place.depth;
  traversal.place.end = range.y;
  traversal.place.position = real(1);
#if TETMARCH_POINT_SCALARS
  traversal.place.cubic = vec4(real(0), real(0), real(0), real(0));
  traversal.place.extremes = vec2(NO_EXTREME, NO_EXTREME);
#endif
#if TETMARCH_BENT_COMPONENTS
  traversal.place.further = noFurtherCubics();
#endif
#if TETMARCH_EFFECTS
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

void enterVolume(Ray ray, INOUT(Traversal) traversal) {}

void leaveVolume(Ray ray, bool finished, INOUT(Traversal) traversal) { traversal.entry.face = -1; }
