// Tetrahedra in 16 bytes (Mesh/PackedCells.h): they are decoded with the data of the ray's entry face.

// A face seen from the ray's side. Half-face 4 t + i is face i of tetrahedron t; LINK_OUTSIDE + b is boundary face b. A
// half-face's link is the half-face on the other side.
struct Side
{
  uint ahead; // half-face of the tetrahedron that the ray enters
  uint link;  // the link of that half-face, on the side that the ray has left
};

Side sideFrom(uint link, uint ahead)
{
  Side side;
  side.ahead = ahead;
  side.link = link;
  return side;
}

bool isOutside(uint halfFace) { return halfFace >= LINK_OUTSIDE; }

// The exclusive or of the links of a face of the tetrahedron and of its face 3.
uint linkDifference(uvec4 cell, uint face)
{
  return face == 0u ? cell.y : (face == 1u ? cell.z : (face == 2u ? cell.w : 0u));
}

uvec4 cellAhead(Side side) { return fetchCell(side.ahead >> 2u); }

// The fourth vertex of the tetrahedron ahead.
uint apexOf(uvec4 cell, Side side, uvec3 ids) { return cell.x ^ ids.x ^ ids.y ^ ids.z; }

// The link of a face of the tetrahedron ahead.
uint linkOf(uvec4 cell, Side side, uint face)
{
  return side.link ^ linkDifference(cell, side.ahead & 3u) ^ linkDifference(cell, face);
}

// The side of another face of the tetrahedron ahead.
Side sideOf(uvec4 cell, Side side, uint face)
{
  return sideFrom(linkOf(cell, side, face), (side.ahead & ~3u) + face);
}

// The other side of a face of the tetrahedron ahead, where the ray leaves it.
Side sideBehind(uvec4 cell, Side side, uint face)
{
  return sideFrom((side.ahead & ~3u) + face, linkOf(cell, side, face));
}

// The boundary face through which the ray has left.
int boundaryFaceAhead(Side side) { return int(side.ahead - LINK_OUTSIDE); }
