// Shades along the interval of a ray in a cell. Empty without effects.

#if TETMARCH_EFFECTS && !TETMARCH_KEEPS_SHADE && !TETMARCH_POINT_SAMPLED
// The point where the interval begins.
FacePoint enterPoint(CellInterval cell)
{
  FacePoint point;
  point.depth = cell.enter.x;
#if TETMARCH_POINT_SCALARS
  point.scalar = cell.enter.y;
#else
  point.scalar = cell.scalar;
#endif
#if TETMARCH_CELL_ATTRIBUTES
  point.attributes = cell.enterAttributes;
#endif
  return point;
}
#endif

#if TETMARCH_EFFECTS && !TETMARCH_POINT_SAMPLED
// The point where it ends.
FacePoint leavePoint(CellInterval cell)
{
  FacePoint point;
  point.depth = cell.leave.x;
  point.scalar = cell.scalar;
#if TETMARCH_CELL_ATTRIBUTES
  point.attributes = cell.leaveAttributes;
#endif
  return point;
}
#endif

#if TETMARCH_LIT_PARTS || TETMARCH_LIGHT_AT_POINTS
// The point at a depth in the cell.
FacePoint pointWithin(Ray ray, CellInterval cell, real depth)
{
  FacePoint point;
  point.depth = depth;
#if TETMARCH_POINT_SCALARS
  point.scalar = scalarIn(cell, depth);
#else
  point.scalar = cell.scalar;
#endif
#if TETMARCH_EVEN_GRADIENT
  point.attributes = attributesWith(cell.gradient, ray, depth);
#elif TETMARCH_STRUCTURED && TETMARCH_EFFECTS
  point.attributes = attributesAt(ray, cell.crossed, depth);
#elif TETMARCH_CELL_ATTRIBUTES
  real f = fractionAt(cell.enter, cell.leave, depth);
  point.attributes = interpolateAttributes(
    cell.enterAttributes, cell.leaveAttributes, cell.leaveAttributes, vec3(real(1) - f, f, real(0)));
#endif
  return point;
}
#endif

#if TETMARCH_KEEPS_SHADE
// Before the first cell, at the ray's entry into the mesh.
void beginShades(Ray ray, INOUT(CellInterval) cell) { cell.leaveShade = shadeAtFace(ray, leavePoint(cell)); }
#endif

// Before cell becomes the next one.
void advanceShades(INOUT(CellInterval) cell)
{
#if TETMARCH_POINT_SAMPLED
  // There are none at the ends of an interval.
#elif TETMARCH_FINDS_SHADES && TETMARCH_SHADES_OF_CELLS
  cell.enterShadeKnown = false;
#elif TETMARCH_FINDS_SHADES
  cell.enterShadeKnown = cell.seen;
#endif
}

// Sets the shades at both ends of an interval; the place is that of its end.
void shadeCell(Ray ray, RayPosition place, INOUT(CellInterval) cell)
{
#if TETMARCH_KEEPS_CROSSED
  cell.crossed = place.crossed;
#endif
#if TETMARCH_EVEN_GRADIENT
  cell.gradient = gradientAt(ray, place.crossed, cell.leave.x);
#endif
#if TETMARCH_LIGHT_AT_POINTS
  if (shadesPoints(ray, cell))
  {
    return;
  }
#endif
#if TETMARCH_POINT_SAMPLED
  // Each sample has its own shade.
#elif TETMARCH_EVEN_SHADE
  FacePoint point = leavePoint(cell);
  point.attributes = attributesWith(cell.gradient, ray, point.depth);
  cell.leaveShade = shadeAtFace(ray, point);
  cell.enterShade = cell.leaveShade;
#elif TETMARCH_FINDS_SHADES
  // The shade at the ray's entry is that at its exit from the last cell, unless that was skipped.
  int missing = cell.enterShadeKnown ? 1 : 2;
  do
  {
    FacePoint point = leavePoint(cell);
    if (missing > 1)
    {
      point = enterPoint(cell);
    }
#if TETMARCH_EVEN_GRADIENT
    point.attributes = attributesWith(cell.gradient, ray, point.depth);
#elif TETMARCH_STRUCTURED
    point.attributes = attributesAt(ray, place.crossed, point.depth);
#endif
    cell.enterShade = cell.leaveShade;
    cell.leaveShade = shadeAtFace(ray, point);
    missing = missing - 1;
  } while (missing > 0);
#elif TETMARCH_VERTEX_GRADIENTS
  cell.enterShade = cell.leaveShade;
  cell.leaveShade = shadeAtFace(ray, leavePoint(cell));
#elif TETMARCH_EFFECTS
  // One gradient, with the light in the middle.
  FacePoint from = enterPoint(cell);
  FacePoint to = leavePoint(cell);
  real depth = real(0.5) * (from.depth + to.depth);
  real scalar = real(0.5) * (from.scalar + to.scalar);
  cell.enterShade = shadeOf(ray, depth, scalar, fetchCellGradient(cell.number),
    (incomingAt(ray, from) + incomingAt(ray, to)) * real(0.5));
  cell.leaveShade = cell.enterShade;
#endif
#if TETMARCH_VERTEX_LIGHT_ERROR
  cell.interpolationError = lightInterpolationError(place.face);
#endif
}

#if TETMARCH_ACCUMULATES_OPACITY
// Before a segment of the cell is gathered.
void placeShades(Segment segment, INOUT(CellInterval) cell)
{
#if TETMARCH_LIT_PARTS
  cell.shadesWithin = vec2(real(0), real(1)); // they are those at the ends of the segment
#elif TETMARCH_EFFECTS
  cell.shadesWithin = rangeWithin(cell, segment);
#endif
}
#endif

#if TETMARCH_EFFECTS
// A fraction of the segment as a fraction of the tetrahedron.
real fractionOfCell(CellInterval cell, real fraction)
{
  return cell.shadesWithin.x + (cell.shadesWithin.y - cell.shadesWithin.x) * fraction;
}

#if TETMARCH_GRADIENT_OPACITY
real densityWithin(CellInterval cell, real fraction)
{
  return cell.enterShade.density + (cell.leaveShade.density - cell.enterShade.density) * fractionOfCell(cell, fraction);
}
#endif

#if TETMARCH_LIT
Illumination illuminationWithin(CellInterval cell, real fraction)
{
  return mixIllumination(cell.enterShade.lit, cell.leaveShade.lit, fractionOfCell(cell, fraction));
}
#endif
#endif
