// The picked point of a ray: the first one at which gathered() of the blend mode reaches the target.

CONSTANT int PICK_STEPS = 32; // halvings of the point's interval

struct Pick
{
  bool hit;
  uint cell;   // its index
  real depth;  // along the ray
  real scalar; // as stored, also if it is not finite
};

Pick noPick()
{
  Pick pick;
  pick.hit = false;
  pick.cell = 0u;
  pick.depth = real(0);
  pick.scalar = real(0);
  return pick;
}

bool isPicked(Radiance radiance, real target)
{
  return gathered(radiance) >= target && gathered(radiance) > gathered(noRadiance());
}

// The radiance after gathering the cell up to a depth.
Radiance gatheredUpTo(real depth, real thicknessPerDepth, CellInterval cell, Radiance radiance)
{
  cell.end = depth;
  gatherCell(thicknessPerDepth, cell, radiance);
  return radiance;
}

// The stored scalar at a depth in the cell.
real pickedScalar(CellInterval cell, real depth)
{
#if TETMARCH_POINT_SCALARS
  real scalar = scalarIn(cell, depth);
#else
  real scalar = cell.scalar;
#endif
#if TETMARCH_NAN_SHOWN
  scalar = cell.finite ? scalar : UNDRAWN_SCALAR;
#endif
  return scalar;
}

// Gathers the cell's interval, and finds the point if it is in it.
void pickInterval(
  real thicknessPerDepth, real target, INOUT(CellInterval) cell, INOUT(Radiance) radiance, INOUT(Pick) pick)
{
  Radiance before = radiance;
  CellInterval searched = cell;
  gatherCell(thicknessPerDepth, cell, radiance);
  if (!pick.hit && isPicked(radiance, target))
  {
    real low = cell.begin;
    real high = cell.end;
    for (int i = 0; i < PICK_STEPS; ++i)
    {
      real middle = low + (high - low) * real(0.5);
      Radiance there = gatheredUpTo(middle, thicknessPerDepth, searched, before);
      bool picked = isPicked(there, target);
      low = picked ? low : middle;
      high = picked ? middle : high;
#if TETMARCH_BENT
      // The part before the point is split into subsegments once, not in each step.
      if (!picked)
      {
        searched.begin = middle;
        before = there;
      }
#endif
    }
    pick.hit = true;
    pick.cell = cell.number;
    pick.depth = high;
    pick.scalar = pickedScalar(cell, high);
  }
}
