// The step from tetrahedron to tetrahedron.

// The scalar of a tetrahedron, or that at the point (depth, scalar) of the ray's exit.
real cellScalar(uint tet, vec2 leave)
{
#if TETMARCH_POINT_SCALARS
  return leave.y;
#else
  return fetchCellScalar(tet);
#endif
}

// The interval before the face through which the ray enters the mesh.
CellInterval beginCellInterval(Ray ray, INOUT(RayPosition) place)
{
  CellInterval cell;
  fetchCorners(place.face);
  placeOnPath(place.side, place.face);
  lookAhead(place);
  beginCell(cell);
  cell.leave = intersectionPoint(place.face);
#if TETMARCH_VERTEX_ATTRIBUTES
  cell.leaveAttributes = attributesAt(place.face);
#endif
  beginLookups(cell);
#if TETMARCH_KEEPS_SHADE
  cell.scalar = cellScalar(place.side.ahead >> 2u, cell.leave);
  beginShades(ray, cell);
#endif
  return cell;
}

// Steps through the tetrahedron behind the face, which becomes the ray's exit face.
Crossing crossCell(Ray ray, INOUT(RayPosition) place, INOUT(CellInterval) cell)
{
  uint tet = place.side.ahead >> 2u;
  EnteredTet ahead = tetAhead(place);
#if TETMARCH_CORNER_SCALARS
  vec2 enter = enterTet(ahead, place);
#else
  vec2 enter = cell.leave;
#endif
#if TETMARCH_CURVED_ERROR
  cell.enterShift = shiftOf(ray, place.face);
#endif
  int exitFace = stepThrough(ray, ahead, place);
#if TETMARCH_CURVED_ERROR
  cell.leaveShift = shiftOf(ray, place.face);
#endif
  keepLastDrawn(cell);
#if TETMARCH_CORNER_SCALARS && TETMARCH_ISOSURFACES
  // A jump crosses no value.
  cell.before = enter.y != cell.leave.y ? vec2(-NO_DEPTH, real(0)) : cell.before;
#endif
  cell.number = tet;
#if TETMARCH_LIT_COMPONENTS
  cell.ray = ray;
#endif
  cell.enter = enter;
  cell.leave = intersectionPoint(place.face);
#if TETMARCH_VERTEX_ATTRIBUTES
  cell.enterAttributes = cell.leaveAttributes;
  cell.leaveAttributes = attributesAt(place.face);
#endif
  cell.scalar = cellScalar(tet, cell.leave);
  Crossing crossing;
  crossing.cells = 1;
  crossing.lost = exitFace < 0;
  crossing.onward = exitFace >= 0 && !isOutside(place.side.ahead);
#if TETMARCH_VISIBLE_PART
  // The next tetrahedron is not marched through if it is invisible.
  crossing.onward = crossing.onward && isInVisiblePart(crossing.onward ? place.side.ahead >> 2u : 0u);
#endif
  return crossing;
}
