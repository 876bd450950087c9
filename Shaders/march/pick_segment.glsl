// The point by which a ray is picked: the first one up to which it has gathered as much as is asked for, of whatever
// the blend mode gathers.

CONSTANT int PICK_STEPS = 32; // halvings of the piece that the point is in

struct Pick
{
  bool hit;
  uint tet;
  real depth;  // along the ray
  real scalar; // as it is stored, also if it is not finite
};

Pick noPick()
{
  Pick pick;
  pick.hit = false;
  pick.tet = 0u;
  pick.depth = real(0);
  pick.scalar = real(0);
  return pick;
}

bool isPicked(Radiance radiance, real target)
{
  return gathered(radiance) >= target && gathered(radiance) > gathered(noRadiance());
}

// With what is seen of the tetrahedron up to a depth.
Radiance gatheredUpTo(real depth, real thicknessPerDepth, CellInterval cell, Radiance radiance)
{
  cell.end = depth;
#if TETMARCH_NAN_SHOWN
  if (!cell.finite)
  {
    absorbNan(radiance, (depth - cell.begin) * thicknessPerDepth);
  }
  else
#endif
  {
    gatherSegment(visibleSegment(cell), thicknessPerDepth, cell, radiance);
  }
  return radiance;
}

// In the place of gatherSegment().
void pickSegment(real thicknessPerDepth, real target, CellInterval cell, INOUT(Radiance) radiance, INOUT(Pick) pick)
{
  Radiance before = radiance;
  radiance = gatheredUpTo(cell.end, thicknessPerDepth, cell, before);
  if (!pick.hit && isPicked(radiance, target))
  {
    real low = cell.begin;
    real high = cell.end;
    for (int i = 0; i < PICK_STEPS; ++i)
    {
      real middle = low + (high - low) * real(0.5);
      bool picked = isPicked(gatheredUpTo(middle, thicknessPerDepth, cell, before), target);
      low = picked ? low : middle;
      high = picked ? middle : high;
    }
    pick.hit = true;
    pick.tet = cell.tet;
    pick.depth = high;
#if TETMARCH_POINT_SCALARS
    pick.scalar = scalarAt(cell.enter, cell.leave, high);
#else
    pick.scalar = cell.scalar;
#endif
#if TETMARCH_NAN_SHOWN
    pick.scalar = cell.finite ? pick.scalar : UNDRAWN_SCALAR;
#endif
  }
}
